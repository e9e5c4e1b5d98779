// SPDX-License-Identifier: MIT
// Draws a chart of the page for a paper: plot REQUEST, a JSON file that holds the page's data, its charts' scripts, the chart and the
// file to write. A Vega-Lite specification needs no package; an SVG is drawn by Vega, without a browser.
const { readFileSync, writeFileSync } = require("node:fs");
const vm = require("node:vm");

const request = JSON.parse(readFileSync(process.argv[2], "utf8"));

// What the page's scripts ask a browser for: the colours of paper.
const inks = { "--text": "#000", "--quiet": "#333", "--rule": "#ddd" };
globalThis.matchMedia = () => ({ matches: false });
globalThis.document = {};
globalThis.getComputedStyle = () => ({ getPropertyValue: (name) => inks[name] });
vm.runInThisContext(request.charts);

// A column of a paper of two is 3.4 inches wide, its captions have 8 points. A figure is measured in CSS pixels, 96 to an inch of 72 points.
const paper = { width: 3.4 * 96, letters: (8 * 96) / 72, frame: 270, height: 200, panel: 130, pointSize: 22, lineWidth: 1.25 };
const font = { font: "Nimbus Roman, Times New Roman, Times, serif" };

// As many columns of a legend as have room for its widest entry.
const legendColumns = ({ scale }) => Math.max(1, Math.min(3, Math.floor(paper.width / (Math.max(...scale.domain.map((line) => widthOfText({}, line))) + 24))));
const sized = (of) => (Array.isArray(of) ? of.map(sized)
  : of === null || typeof of !== "object" ? of
  : Object.fromEntries(Object.entries(of).map(([key, value]) => [key, key === "legend" && value?.columns?.expr ? { ...value, columns: legendColumns(of), labelLimit: 0 }
    : key === "size" && typeof value === "number" ? paper.pointSize
    : key === "fontSize" ? paper.letters
    : key === "strokeWidth" && typeof value === "number" && of.interpolate === undefined ? Math.min(value, paper.lineWidth)
    : key === "tooltip" ? null : sized(value)])));

function specification() {
  const { data, kind, chart, columns, schemes } = request;
  const [section] = data.sections;
  const charts = vm.runInThisContext("(section, lines, kind, kinds, wants, columns) => chartsOfSection(section, lines, kind, kinds, wants, columns)");
  const made = charts(section, data.lines, data.kinds.find(({ id }) => id === kind), data.kinds,
    (line) => schemes.length === 0 || schemes.includes(line.split(",")[0]), columns.length > 0 ? columns : undefined);
  const found = [...made, ...chartsOfMeasurements(section)].find(({ id }) => id === chart);
  if (!found) throw new Error(`there is no ${chart.replaceAll("-", " ")} of this scene`);
  const { params, ...spec } = sized(found.spec);
  const layers = spec.layer?.map(({ params: _, ...layer }) => layer);
  const plain = JSON.parse(JSON.stringify({ ...spec, ...(layers && { layer: layers }) }, (key, value) => (key === "opacity" && value?.condition ? undefined : value)));
  const text = { labelFontSize: paper.letters, titleFontSize: paper.letters, titleFontWeight: "normal", labelColor: "#000", titleColor: "#000", tickSize: 3, ...{ labelFont: font.font, titleFont: font.font } };
  // What has a width of its own keeps its shape.
  const size = { width: paper.frame, height: typeof plain.width === "number" ? (paper.frame * plain.height) / plain.width : paper.height };
  const sizes = plain.vconcat ? { vconcat: plain.vconcat.map((panel) => ({ ...panel, width: paper.frame, height: paper.panel })) } : size;
  const { width: _w, height: _h, ...rest } = plain;
  const figure = { ...rest, ...sizes, autosize: { type: "pad" }, background: "white", padding: 2,
    config: { ...plain.config, font: font.font, axis: { ...plain.config.axis, ...text },
      legend: { ...text, labelColor: "#000", symbolSize: 40, rowPadding: 1, columnPadding: 8, offset: 6 } } };
  return { spec: figure, keepsShape: typeof plain.width === "number" };
}

// Without a browser Vega takes letters for much wider than those of Times are, which stretches legends and margins.
const emsOf = (letter) => (/[ijlt.,:;'|/ I]/.test(letter) ? 0.28 : /[frsJ-]/.test(letter) ? 0.36 : /[mwM]/.test(letter) ? 0.78 : /[A-Z]/.test(letter) ? 0.68 : 0.5);
const widthOfText = ({ fontSize = paper.letters }, text) => fontSize * [...String(text ?? "")].reduce((sum, letter) => sum + emsOf(letter), 0);

function drawing() {
  if (!request.vega) throw new Error("this fdebench was built without the packages of setup.sh");
  vm.runInThisContext(request.vega);
  vega.textMetrics.width = widthOfText;
  return (spec) => new vega.View(vega.parse(vegaLite.compile(spec).spec), { renderer: "none" }).toSVG();
}

const widthOf = (svg) => Number(/width="([\d.]+)"/.exec(svg)[1]);

// The frame wider or narrower, what has a shape of its own higher or lower too.
const resized = (spec, width, keepsShape) => (spec.vconcat ? { ...spec, vconcat: spec.vconcat.map((panel) => ({ ...panel, width })) }
  : { ...spec, width, height: keepsShape ? (spec.height * width) / spec.width : spec.height });

// The drawing at the width of a column; its content keeps its shape, because the viewBox stays.
function shrunk(svg) {
  const part = paper.width / widthOf(svg), height = Number(/height="([\d.]+)"/.exec(svg)[1]);
  return svg.replace(/ width="[\d.]+"/, ` width="${paper.width.toFixed(1)}"`).replace(/ height="[\d.]+"/, ` height="${(height * part).toFixed(1)}"`);
}

// The specification whose frame, axes and legend together are as wide as `wanted`, and its drawing. Ticks may change with the width.
async function drawnAs(wanted, { spec, keepsShape }, draw) {
  let svg = await draw(spec), fits = spec;
  for (let turn = 0; turn < 4 && Math.abs(widthOf(svg) - wanted) > 0.5; ++turn) {
    const width = (fits.vconcat?.[0] ?? fits).width + wanted - widthOf(svg);
    fits = resized(fits, Math.max(width, paper.width / 3), keepsShape);
    svg = await draw(fits);
  }
  return { spec: fits, svg };
}

// As wide as a column. What does not fit, as a long name in a legend, makes a wider drawing that is reduced as a whole.
async function fitted(figure) {
  const draw = drawing();
  let drawn = await drawnAs(paper.width, figure, draw);
  if (widthOf(drawn.svg) > paper.width + 0.5) {
    const wanted = widthOf(drawn.svg);
    drawn = await drawnAs(wanted, { ...figure, spec: resized(figure.spec, wanted, figure.keepsShape) }, draw);
    return { spec: drawn.spec, svg: shrunk(drawn.svg) };
  }
  // The last fraction of a pixel is white.
  return { spec: drawn.spec, svg: drawn.svg.replace(/ width="[\d.]+"/, ` width="${paper.width.toFixed(1)}"`).replace(/ viewBox="0 0 [\d.]+ /, ` viewBox="0 0 ${paper.width.toFixed(1)} `) };
}

async function write() {
  const figure = specification();
  const drawn = request.out.endsWith(".svg") ? (await fitted(figure)).svg : `${JSON.stringify(figure.spec, null, 1)}\n`;
  writeFileSync(request.out, drawn);
}

write().catch((error) => {
  console.error(error.message);
  process.exitCode = 1;
});
