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
const { panels, style } = request;
const letterSize = (8 * 96) / 72, gap = 14;
const frame = (style.width * 96 - gap * (panels.length - 1)) / panels.length - 56;
const paper = { width: style.width * 96, letters: letterSize, frame, height: Math.max(200, Math.min(320, frame / 2)), panel: 130, pointSize: 22, lineWidth: 1.25 };
const font = { font: "Nimbus Roman, Times New Roman, Times, serif" };
vm.runInThisContext("(frame, names) => { labelFrame = frame; ownNames = new Map(Object.entries(names)); }")({ width: paper.frame, height: paper.height, letters: letterSize }, style.names);

// As many columns of a legend as have room for its widest entry: that of lines is beneath all panels, any other beneath its own.
function legendColumns({ field, scale: { domain } }) {
  const [room, name, symbol] = field === "line" ? [paper.width, nameOf, 34] : [paper.frame + 40, (text) => symbolOf(text, domain), 46];
  return Math.max(1, Math.floor(room / (Math.max(...domain.map((text) => widthOfText({}, name(text)))) + symbol)));
}
const sized = (of) => (Array.isArray(of) ? of.map(sized)
  : of === null || typeof of !== "object" ? of
  : Object.fromEntries(Object.entries(of).map(([key, value]) => [key, key === "legend" && value?.orient === "bottom" && of.scale?.domain ? { ...value, columns: legendColumns(of), labelLimit: 0 }
    : key === "size" && typeof value === "number" ? paper.pointSize
    : key === "fontSize" ? paper.letters
    : key === "strokeWidth" && typeof value === "number" && of.interpolate === undefined ? Math.min(value, paper.lineWidth)
    : key === "tooltip" ? null : sized(value)])));

const chartsOfData = vm.runInThisContext("(section, lines, kind, kinds, wants, columns) => chartsOfSection(section, lines, kind, kinds, wants, columns)");

function panelOf(data) {
  const { kind, chart, columns, schemes } = request, [section] = data.sections;
  const made = chartsOfData(section, data.lines, data.kinds.find(({ id }) => id === kind), data.kinds,
    (line) => schemes.length === 0 || schemes.includes(line.split(",")[0]), columns.length > 0 ? columns : undefined);
  const found = [...made, ...chartsOfMeasurements(section)].find(({ id }) => id === chart);
  if (!found) throw new Refusal(`--kind: there is no ${chart.replaceAll("-", " ")} of ${data.scene}`);
  const { params, ...spec } = sized(withNames({ ...found, spec: withAxes(found.spec) }, data.lines));
  const layers = spec.layer?.map(({ params: _, ...layer }) => layer);
  const plain = JSON.parse(JSON.stringify({ ...spec, ...(layers && { layer: layers }) }, (key, value) => (key === "opacity" && value?.condition ? undefined : value)));
  // What has a width of its own keeps its shape.
  const keepsShape = typeof plain.width === "number";
  const size = { width: paper.frame, height: keepsShape ? (paper.frame * plain.height) / plain.width : paper.height };
  const sizes = plain.vconcat ? { vconcat: plain.vconcat.map((panel) => ({ ...panel, width: paper.frame, height: paper.panel })) } : size;
  const { width: _w, height: _h, ...rest } = plain;
  return { spec: { ...rest, ...sizes }, keepsShape, title: nameOf(data.scene) };
}

// One panel, or several side by side.
function specification() {
  const made = panels.map(panelOf);
  const text = { labelFontSize: paper.letters, titleFontSize: paper.letters, titleFontWeight: "normal", labelColor: "#000", titleColor: "#000", tickSize: 3, ...{ labelFont: font.font, titleFont: font.font } };
  const { config, $schema, description } = made[0].spec;
  const shared = { $schema, description, autosize: { type: "pad" }, background: "white", padding: 2,
    config: { ...config, font: font.font, axis: { ...config.axis, ...text }, title: { font: font.font, fontSize: paper.letters, fontWeight: "normal", color: "#000", offset: 4 },
      concat: { spacing: gap }, legend: { ...text, labelColor: "#000", symbolSize: 40, rowPadding: 1, columnPadding: 8, offset: 6 } } };
  if (made.length === 1) return { spec: { ...made[0].spec, ...shared }, keepsShape: made[0].keepsShape };
  const side = ({ spec: { config: _c, $schema: _s, background: _b, autosize: _a, ...spec }, title }) =>
    (spec.vconcat ? { ...spec, vconcat: spec.vconcat.map((panel, i) => (i ? panel : { ...panel, title })) } : { ...spec, title });
  return { spec: { ...shared, ...sideBySide(made.map(side)) }, keepsShape: made.some((one) => one.keepsShape) };
}

async function write() {
  const figure = specification();
  const drawn = request.out.endsWith(".svg") ? (await fitted(figure)).svg : `${JSON.stringify(figure.spec, null, 1)}\n`;
  writeFileSync(request.out, drawn);
}

write().catch((error) => {
  console.error(error.message);
  process.exitCode = error instanceof Refusal ? 2 : 1;
});
