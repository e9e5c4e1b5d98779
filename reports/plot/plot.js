// Draws a chart of the page for a paper: plot REQUEST, a JSON file that holds the page's data, its charts' scripts, the chart and the
// file to write. A Vega-Lite specification needs no package; an SVG is drawn by Vega, without a browser.
const { readFileSync, writeFileSync } = require("node:fs");
const { pathToFileURL } = require("node:url");
const vm = require("node:vm");

const request = JSON.parse(readFileSync(process.argv[2], "utf8"));

// What the page's scripts ask a browser for: the colours of paper.
const inks = { "--text": "#000", "--quiet": "#333", "--rule": "#ddd" };
globalThis.matchMedia = () => ({ matches: false });
globalThis.document = {};
globalThis.getComputedStyle = () => ({ getPropertyValue: (name) => inks[name] });
vm.runInThisContext(request.charts);

// A column of a paper of two is 3.4 inches wide, its captions have 8 points.
const paper = { width: 190, height: 150, pointSize: 14, lineWidth: 1 };
const font = { font: "Nimbus Roman, Times New Roman, Times, serif" };
const sized = (of) => (Array.isArray(of) ? of.map(sized)
  : of === null || typeof of !== "object" ? of
  : Object.fromEntries(Object.entries(of).map(([key, value]) => [key, key === "columns" && value?.expr ? 2
    : key === "size" && typeof value === "number" ? paper.pointSize
    : key === "strokeWidth" && typeof value === "number" && of.interpolate === undefined ? Math.min(value, paper.lineWidth)
    : key === "tooltip" ? null : sized(value)])));

function specification() {
  const { data, kind, chart, columns, schemes } = request;
  const [section] = data.sections;
  const charts = vm.runInThisContext("(section, lines, kind, kinds, wants, columns) => chartsOfSection(section, lines, kind, kinds, wants, columns)");
  const made = charts(section, data.lines, data.kinds.find(({ id }) => id === kind), data.kinds,
    (line) => schemes.length === 0 || schemes.includes(line.split(",")[0]), columns.length > 0 ? columns : undefined);
  const found = made.find(({ id }) => id === chart);
  if (!found) throw new Error(`there is no ${chart.replaceAll("-", " ")} of this scene`);
  const { params, ...spec } = sized(found.spec);
  const layers = spec.layer?.map(({ params: _, ...layer }) => layer);
  const plain = JSON.parse(JSON.stringify({ ...spec, ...(layers && { layer: layers }) }, (key, value) => (key === "opacity" && value?.condition ? undefined : value)));
  const text = { labelFontSize: 8, titleFontSize: 8, titleFontWeight: "normal", labelColor: "#000", titleColor: "#000", tickSize: 3, ...{ labelFont: font.font, titleFont: font.font } };
  // What has a width of its own keeps its shape.
  const size = typeof plain.width === "number" ? { width: paper.width, height: (paper.width * plain.height) / plain.width } : { width: paper.width, height: paper.height };
  const sizes = plain.vconcat ? { vconcat: plain.vconcat.map((panel) => ({ ...panel, width: paper.width, height: 100 })) } : size;
  const { width: _w, height: _h, ...rest } = plain;
  return { ...rest, ...sizes, autosize: { type: "pad" }, background: "white", padding: 2,
    config: { ...plain.config, font: font.font, axis: { ...plain.config.axis, ...text },
      legend: { ...text, labelColor: "#000", symbolSize: 30, rowPadding: 1, columnPadding: 8, labelLimit: 140, offset: 6 } } };
}

// Without a browser Vega takes letters for much wider than those of Times are, which stretches legends and margins.
const widthOfText = ({ fontSize = 8 }, text) => 0.5 * fontSize * String(text ?? "").length;

async function svgOf(spec) {
  const load = (name, file) => import(pathToFileURL(`${request.modules}/${name}/build/${file}`));
  const [vega, { compile }] = await Promise.all([load("vega", "vega.module.js"), load("vega-lite", "index.js")]);
  vega.textMetrics.width = widthOfText;
  return new vega.View(vega.parse(compile(spec).spec), { renderer: "none" }).toSVG();
}

async function write() {
  const spec = specification();
  writeFileSync(request.out, request.out.endsWith(".svg") ? await svgOf(spec) : `${JSON.stringify(spec, null, 1)}\n`);
}

write().catch((error) => {
  console.error(error.message);
  process.exitCode = 1;
});
