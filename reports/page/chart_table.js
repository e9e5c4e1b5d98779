// SPDX-License-Identifier: MIT
// The numbers behind a chart: a table for readers, comma-separated values for programs.

const columnsOfCharts = {
  line: { title: "scheme" },
  steps: { title: "N", text: String },
  requested: { title: "requested", text: fewDigits },
  h: { title: "h", text: (value) => value.toPrecision(3) },
  time_minimum: { title: "run time in s", text: (value) => value.toPrecision(3) },
  history_bytes: { title: "memory of the history in bytes", text: String },
  error: { text: fewDigits },
  ratio: { title: "ratio", text: fewDigits },
  energy_residual: { title: "energy residual", text: fewDigits },
  formulation: { title: "formulation", text: String },
  drift: { title: "drift", text: fewDigits },
  order: { title: "γ", text: String },
  re: { title: "Re z", text: String },
  im: { title: "Im z", text: String },
  parameter: { title: "parameter", text: String },
  value: { title: "value", text: String },
  column: { title: "column", text: String },
  t: { title: "t", text: String },
  x: { title: "x", text: String },
  y: { title: "y", text: String },
  z: { title: "z", text: String },
  share: { title: "share", text: (value) => numberFormats.percent(value) },
  state: { title: "state", text: (value) => statesOfCells[value] },
  seconds: { title: "run time in s", text: (value) => value.toPrecision(3) },
  second: { title: "second", text: String },
  times: { title: "its time to the least", text: (value) => numberFormats.three(value) },
};

// Those that a point of the chart has, each { field, title, text }.
function columnsOf({ points, columns }, titles) {
  return columns.filter((field) => points.some((point) => point[field] !== undefined))
    .map((field) => ({ field, ...columnsOfCharts[field], ...(titles[field] && { title: titles[field] }) }));
}

// opens: called with a point whose row is chosen, where the chart shows more of its points.
function numbersTable(chart, titles, opens) {
  const columns = columnsOf(chart, titles);
  const cell = (point, { field, text }) => field === "line" && point.line !== undefined ? { text: point.line, line: point.line } : { text: point[field] === undefined ? "" : text(point[field]) };
  return {
    caption: `The numbers of: ${chart.title}`, columns: columns.map(({ title }) => ({ text: title })),
    groups: [{ rows: chart.points.map((point) => columns.map((column, i) => ({ ...cell(point, column), ...(chart.opens && i === 0 && { opens: () => opens(point) }) }))) }],
  };
}

function csvOf(chart, titles) {
  const columns = columnsOf(chart, titles);
  const quoted = (value) => (/[",]/.test(value) ? `"${String(value).replaceAll('"', '""')}"` : String(value ?? ""));
  return [columns.map(({ title }) => title), ...chart.points.map((point) => columns.map(({ field }) => point[field]))]
    .map((row) => `${row.map(quoted).join(",")}\n`).join("");
}
