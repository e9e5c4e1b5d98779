"use strict";

// Charts as Vega-Lite specifications over the points that the report computed.

const isDark = matchMedia("(prefers-color-scheme: dark)").matches;

// Okabe and Ito's colours, told apart by most colour-blind readers; yellow is left out, it is too faint on white. Their black
// is the colour of the text.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", isDark ? "#c4c8ce" : "#333333", "#8c564b"];
const shapes = ["circle", "square", "triangle-up", "diamond", "cross", "triangle-down", "triangle-right", "triangle-left"];

const colourOf = (lines, line) => colours[lines.indexOf(line) % colours.length];
// Lines beyond the last colour have the first colours again, with other shapes.
const shapeOf = (lines, line) => {
  const place = lines.indexOf(line);
  return shapes[(place + Math.floor(place / colours.length)) % shapes.length];
};

const labels = {
  number: "replace(format(datum.value, '.0e'), '+', '')",
  time: "format(datum.value, '~s') + 's'",
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

// Colour and shape of the lines in this chart, the same on the whole page. A click in the legend isolates a line.
function lineChannels(lines, shown) {
  const widest = 7 * Math.max(...shown.map((line) => line.length)) + 26;
  const columns = { expr: `clamp(floor((containerSize()[0] - 60) / ${widest}), 1, 3)` };  // of width it would chase itself
  const scale = (of) => ({ domain: shown, range: shown.map((line) => of(lines, line)) });
  const legend = { orient: "bottom", columns, title: null, symbolOpacity: 1, labelLimit: 260 };
  const opacity = { condition: { param: "picked", value: 1 }, value: 0.08 };
  return {
    colour: { color: { field: "line", type: "nominal", scale: scale(colourOf), legend }, opacity },
    shape: { shape: { field: "line", type: "nominal", scale: scale(shapeOf), legend } },
  };
}

const picked = { name: "picked", select: { type: "point", fields: ["line"] }, bind: "legend" };

// Lines through the points of each scheme, by default in the order of their steps; hovering shows a point's words.
function lineLayers(encoding, channels, field = "steps") {
  const all = { ...encoding, ...channels.colour };
  return [
    { mark: { type: "line", strokeWidth: 1.5 }, encoding: { ...all, order: { field, type: "quantitative" } } },
    {
      mark: { type: "point", filled: true, size: 45, tooltip: { expr: "datum.words" } },
      params: [picked],
      encoding: { ...all, ...channels.shape },
    },
  ];
}

const ofPage = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

function chart(description, points, rest) {
  const [text, quiet, rule] = ["--text", "--quiet", "--rule"].map(ofPage);
  return {
    $schema: "https://vega.github.io/schema/vega-lite/v6.json",
    description, width: "container", height: 300, data: { values: points },
    autosize: { type: "fit-x", contains: "padding" },
    background: "transparent",
    config: { font: "system-ui, sans-serif", view: { stroke: null }, axis: { gridColor: rule, domainColor: quiet,
      tickColor: quiet, labelColor: quiet, titleColor: text, titleFontWeight: 500, labelFontSize: 11, titleFontSize: 12 },
      legend: { labelFontSize: 11.5, labelColor: text } },
    ...rest,
  };
}

function errorAgainstTime(scene, channels, kind) {
  const points = scene.points.filter((point) => point.error && point.seconds);
  const encoding = { x: logAxis(points, "seconds", "run time", labels.time), y: logAxis(points, "error", kind.title, labels.number) };
  return {
    id: "error-against-time", title: "Error against run time", points,
    spec: chart(`${scene.title}: ${kind.title} against run time, a line for each scheme`, points,
      { layer: lineLayers(encoding, channels) }),
  };
}

// Dashed lines have the slope that theory promises.
function errorAgainstStep(scene, channels, kind) {
  const points = scene.points.filter((point) => point.error);
  const encoding = { x: logAxis(points, "h", "step h", labels.number), y: logAxis(points, "error", kind.title, labels.number) };
  const guides = {
    data: { values: scene.guides.filter((guide) => guide.kind === kind.id) },
    mark: { type: "line", strokeDash: [4, 4], strokeWidth: 1 }, encoding: { ...encoding, ...channels.colour },
  };
  return {
    id: "error-against-step", title: "Error against step; dashed: theoretical rate", points,
    spec: chart(`${scene.title}: ${kind.title} against step, a line for each scheme and dashed its theoretical rate`, points,
      { layer: [guides, ...lineLayers(encoding, channels)] }),
  };
}

function energyAgainstStep(scene, channels) {
  const points = scene.points.filter((point) => point.energy);
  const encoding = { x: logAxis(points, "h", "step h", labels.number), y: logAxis(points, "energy", "energy residual", labels.number) };
  return {
    id: "energy-against-step", title: "Residual of the energy balance against step", points,
    spec: chart(`${scene.title}: largest residual of the energy balance against step, a line for each scheme`, points,
      { layer: lineLayers(encoding, channels) }),
  };
}

// What is named by a field, over the parameter of the section.
function overParameter(field, labelExpr, nameOf) {
  return (section, channels, kind) => {
    const name = nameOf(kind);
    const points = section.points.filter((point) => point[field]);
    const encoding = { x: parameterAxis(points, section.parameter), y: logAxis(points, field, name, labelExpr) };
    return {
      id: `${field}-over-parameter`, title: `${name[0].toUpperCase()}${name.slice(1)} over ${section.parameter}`, points,
      spec: chart(`${section.title}: ${name}, a line for each scheme`, points, { layer: lineLayers(encoding, channels, "value") }),
    };
  };
}

const chartsOfScenes = [errorAgainstTime, errorAgainstStep, energyAgainstStep];
const chartsOfCurves = [
  overParameter("error", labels.number, (kind) => kind.title), overParameter("seconds", labels.time, () => "run time"),
];

// What a point's tooltip says of its errors of all kinds: 1.2e-7.
const errorWords = ({ errors }, kinds) =>
  kinds.filter(({ id }) => errors[id]).map(({ id, title }) => [title, errors[id].toExponential(1)]);

// The charts of a scene, or over a parameter, that have points, as { title, spec }, with errors of this kind.
function chartsOf(scene, lines, kind, kinds) {
  const shown = lines.filter((line) => scene.points.some((point) => point.line === line));
  const channels = lineChannels(lines, shown);
  const drawn = { ...scene, points: scene.points.map((point) =>
    ({ ...point, error: point.errors[kind.id], words: Object.fromEntries([...point.words, ...errorWords(point, kinds)]) })) };
  return (scene.parameter ? chartsOfCurves : chartsOfScenes)
    .map((make) => make(drawn, channels, kind)).filter((made) => made.points.length > 0);
}
