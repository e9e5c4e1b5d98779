// SPDX-License-Identifier: MIT
// The numbers behind a chart: a table for readers, comma-separated values for programs.

// Where a column is not headed by its field, and where its values are not written as they are.
const headingsOfCharts = {
  line: "scheme", steps: "N", time_minimum: "run time in s", history_bytes: "memory of the history in bytes", energy_residual: "energy residual", order: "γ",
  re: "Re z", im: "Im z", seconds: "run time in s", times: "its time to the least",
};
const textsOfCharts = {
  requested: fewDigits, h: (value) => value.toPrecision(3), time_minimum: (value) => value.toPrecision(3), error: fewDigits, ratio: fewDigits,
  energy_residual: fewDigits, drift: fewDigits, share: numberFormats.percent, state: (value) => statesOfCells[value], seconds: (value) => value.toPrecision(3),
  times: numberFormats.three,
};

// Those that a point of the chart has, each { field, title, text }.
function columnsOf({ points, columns }, titles) {
  return columns.filter((field) => points.some((point) => point[field] !== undefined))
    .map((field) => ({ field, title: titles[field] || (headingsOfCharts[field] ?? field), text: textsOfCharts[field] ?? String }));
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
