// SPDX-License-Identifier: MIT
// Charts as Vega-Lite specifications over the points that the report computed.

const labels = {
  number: "replace(format(datum.value, '.0e'), '+', '')",
  time: "format(datum.value, '~s') + 's'",
  bytes: "format(datum.value, '~s') + 'B'",
};

// Where a logarithmic axis carries labels: powers of ten, with 2 and 5 times them where those are few.
function ticks(values) {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const decades = Math.log10(high / low);
  const found = [];
  for (let power = Math.floor(Math.log10(low)) - 1; power <= Math.log10(high) + 1; power += decades > 10 ? 2 : 1) {
    for (const digit of decades > 2.5 ? [1] : [1, 2, 5]) found.push(Number(`${digit}e${power}`));
  }
  return found.filter((tick) => tick >= 0.8 * low && tick <= 1.25 * high);
}

function logAxis(points, field, title, labelExpr) {
  return {
    field, title, type: "quantitative", scale: { type: "log", nice: false, padding: 14 },
    axis: { labelExpr, values: ticks(points.map((point) => point[field])), labelOverlap: true, labelFlush: false },
  };
}

// Of a parameter: logarithmic where its values are of several sizes.
function parameterAxis(points, title) {
  const values = points.map((point) => point.value);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  if (low > 0 && high > 50 * low) return logAxis(points, "value", title, labels.number);
  return { field: "value", title, type: "quantitative", scale: { zero: false, nice: false, padding: 14 } };
}

// Names of one's own for lines and columns, where a figure for a paper has some.
let ownNames = new Map();
const nameOf = (text) => ownNames.get(text) ?? text;
const listInExpression = (texts) => JSON.stringify(texts).replace(/[\u2028\u2029]/g, (mark) => `\\u${mark.charCodeAt(0).toString(16)}`);
const namesInLegend = (texts, name = nameOf) => `${listInExpression(texts.map((text) => labelOf(name(text))))}[indexof(${listInExpression(texts.map(labelOf))}, datum.label)]`;

// Colour, shape and dashes of the lines in this chart, the same on the whole page. A click in the legend isolates a line.
function lineChannels(lines, points) {
  const shown = lines.filter((line) => points.some((point) => point.line === line));
  const widest = 7 * Math.max(0, ...shown.map((line) => line.length)) + 26;
  const columns = { expr: `clamp(floor((containerSize()[0] - 60) / ${widest}), 1, 3)` };  // of width it would chase itself
  const scale = (of) => ({ domain: shown, range: shown.map((line) => of(lines, line)) });
  const legend = { orient: "bottom", columns, title: null, symbolOpacity: 1, labelLimit: 260, ...(ownNames.size > 0 && { labelExpr: namesInLegend(shown) }) };
  const opacity = { condition: { param: "picked", value: 1 }, value: 0.08 };
  return {
    colour: { color: { field: "line", type: "nominal", scale: scale(colourOf), legend }, opacity },
    shape: { shape: { field: "line", type: "nominal", scale: scale(shapeOf), legend } },
    dashes: { strokeDash: { field: "line", type: "nominal", scale: scale(dashesOf), legend } },
  };
}

const picked = { name: "picked", select: { type: "point", fields: ["line"] }, bind: "legend" };

// Lines through the points of each scheme, by default in the order of their resolution; hovering shows a point's words.
function lineLayers(encoding, lines, points, field = "rank") {
  const channels = lineChannels(lines, points);
  const all = { ...encoding, ...channels.colour };
  return [
    { mark: { type: "line", strokeWidth: 1.5 }, encoding: { ...all, ...channels.dashes, order: { field, type: "quantitative" } } },
    {
      mark: { type: "point", filled: true, size: 45, tooltip: { expr: "datum.words" } },
      params: [picked],
      encoding: { ...all, ...channels.shape },
    },
  ];
}

const ofPage = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

// Vega keeps curves by their names in objects, where a name like "constructor" is taken: an invisible word joiner sets it apart.
const labelOf = (text) => (text in Object.prototype ? `\u2060${text}` : text);
function withLabels(spec) {
  if (typeof spec === "string") return labelOf(spec);
  if (Array.isArray(spec)) return spec.map(withLabels);
  if (spec === null || typeof spec !== "object") return spec;
  return Object.fromEntries(Object.entries(spec).map(([key, value]) => [key, withLabels(value)]));
}

function chart(description, points, rest) {
  const [text, quiet, rule] = ["--text", "--quiet", "--rule"].map(ofPage);
  return withLabels({
    $schema: "https://vega.github.io/schema/vega-lite/v6.json",
    description, width: "container", height: 300, data: { values: points },
    autosize: { type: "fit-x", contains: "padding" },
    background: "transparent",
    config: { font: "system-ui, sans-serif", view: { stroke: null }, axis: { gridColor: rule, domainColor: quiet,
      tickColor: quiet, labelColor: quiet, titleColor: text, titleFontWeight: 500, labelFontSize: 11, titleFontSize: 12 },
      legend: { labelFontSize: 11.5, labelColor: text } },
    ...rest,
  });
}
