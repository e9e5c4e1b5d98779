// SPDX-License-Identifier: MIT
// Solutions that differ in one parameter: a curve for each value, a panel for each column that is wanted. Where the solution is not
// continuous in the parameter its curve is dashed, and a note beneath says what its neighbours tend to.

// A sentence with names of columns as symbols: D^beta phi, phi' - phi'(0) are Dᵝφ, φ′ − φ′(0).
const symbolsIn = (text) => text.replace(/D\^(\w+) (\w+)/g, (_, order, of) => symbolOf(`D${order}_${of}`)).replace(/[A-Za-z]+/g, (word) => letters.get(word) ?? word)
  .replaceAll("'", "′").replaceAll(" - ", " − ");
const colourOfValue = ({ parameter, members }) => ({
  field: "parameter", type: "ordinal", title: symbolOf(parameter), scale: { domain: members.map(({ value }) => value), scheme: "viridis", reverse: true },
  legend: { orient: "right", symbolType: "stroke" },
});
const dashedWhereApart = { condition: { test: "datum.apart", value: [4, 3] }, value: [1, 0] };
function noteOfFamily({ parameter, members }) {
  const text = members.filter(({ limits }) => limits).flatMap(({ value, limits }) =>
    [`Dashed: ${symbolOf(parameter)} = ${value}, not the limit of its neighbours.`, ...limits.map((limit) => `As ${symbolOf(parameter)} → ${value}, ${symbolsIn(limit)}.`)]);
  return text.length > 0 && { title: { text, orient: "bottom", anchor: "start", fontWeight: "normal", fontSize: 11, offset: 8 } };
}

function familyOverTime({ title, family }, wanted) {
  const { parameter, members } = family;
  const columns = wanted ?? [members[0].solution.columns[0]];
  const points = members.flatMap(({ value, solution, limits }) =>
    rowsOfColumns(chosenPart(solution, columns), solution.t).map((row) => ({ ...row, parameter: value, ...(limits && { apart: true }) })));
  const color = colourOfValue(family);
  const panel = (column) => ({
    transform: [{ filter: { field: "column", equal: column } }], mark: { type: "line", strokeWidth: 1 },
    encoding: { x: linear("t", "t"), y: linear("value", symbolOf(column, columns)), color, strokeDash: dashedWhereApart, detail: { field: "parameter" }, order: { field: "t" } },
  });
  return {
    id: "family", title: `The solution over ${parameter}`, points, columns: ["parameter", "column", "t", "value"],
    spec: chart(`${title}: ${columns.join(", ")} against t for ${members.length} values of ${parameter}`, points, { ...noteOfFamily(family), vconcat: columns.map(panel) }),
  };
}

function familyPhases({ title, family }, wanted) {
  const { parameter, members } = family;
  const columns = wanted ?? members[0].solution.columns.slice(0, 2);
  const points = members.flatMap(({ value, solution, limits }) => {
    const { values: [x, y] } = chosenPart(solution, columns);
    return solution.t.map((t, i) => ({ parameter: value, t, x: x[i], y: y[i], ...(limits && { apart: true }) }));
  });
  const color = colourOfValue(family);
  return {
    id: "family-phase", title: `${columns[1]} against ${columns[0]} over ${parameter}`, points, columns: ["parameter", "t", "x", "y"],
    spec: chart(`${title}: ${columns[1]} against ${columns[0]}`, points, { ...noteOfFamily(family), mark: { type: "line", strokeWidth: 1 },
      encoding: { x: linear("x", symbolOf(columns[0], columns)), y: linear("y", symbolOf(columns[1], columns)), color, strokeDash: dashedWhereApart, detail: { field: "parameter" }, order: { field: "t" } } }),
  };
}

const chartsOfFamily = (section, wanted) => (section.family ? [familyOverTime(section, wanted), ...(wanted?.length === 2 ? [familyPhases(section, wanted)] : [])] : []);
