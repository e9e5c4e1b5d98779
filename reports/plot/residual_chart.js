// SPDX-License-Identifier: MIT
// Measurements over the solution, and below what it leaves of them, with bars of one standard deviation where these are known.

function chartsOfMeasurements({ title, solution, measured }) {
  if (!measured) return [];
  const columns = solution.columns.filter((column) => measured.some((point) => point.column === column));
  const channels = columnChannels(columns);
  const solved = rowsOfColumns(chosenPart(solution, columns), solution.t);
  const x = linear("t", "t"), names = columns.map((column) => symbolOf(column, columns)).join(", ");
  const pointsOf = (field, name) => {
    const rows = measured.map((point) => ({ ...point, low: point[field] - point.deviation, high: point[field] + point.deviation }));
    const encoding = { x, color: channels.color };
    const bars = { data: { values: rows.filter(({ deviation }) => deviation) }, mark: { type: "rule", strokeWidth: 1 }, encoding: { ...encoding, y: linear("low", name), y2: { field: "high" } } };
    return [bars, { data: { values: rows }, mark: { type: "point", filled: true, size: 30 }, encoding: { ...encoding, y: linear(field, name) } }];
  };
  const curves = { data: { values: solved }, mark: { type: "line", strokeWidth: 1.5 }, encoding: { x, y: linear("value", names), ...channels, order: { field: "t" } } };
  const zero = { data: { values: [{ residual: 0 }] }, mark: { type: "rule", strokeWidth: 1 }, encoding: { y: linear("residual", nameOf("residual")) } };
  return [{ id: "residuals", points: measured, spec: chart(`${title}: measurements, the solution and residuals`, [], {
    resolve: { scale: { x: "shared" } }, spacing: 12, vconcat: [{ layer: [curves, ...pointsOf("value", names)] }, { layer: [zero, ...pointsOf("residual", nameOf("residual"))] }],
  }) }];
}
