// Solutions that differ in one parameter: a curve for each value, a panel for each column that is wanted.

function familyOverTime({ title, family }, wanted) {
  const { parameter, members } = family;
  const columns = wanted ?? [members[0].solution.columns[0]];
  const values = members.map(({ value }) => value);
  const points = members.flatMap(({ value, solution }) => rowsOfColumns(chosenPart(solution, columns), solution.t).map((row) => ({ ...row, parameter: value })));
  const color = { field: "parameter", type: "ordinal", title: symbolOf(parameter), scale: { domain: values, scheme: "viridis", reverse: true }, legend: { orient: "right", symbolType: "stroke" } };
  const panel = (column) => ({
    transform: [{ filter: { field: "column", equal: column } }], mark: { type: "line", strokeWidth: 1 },
    encoding: { x: linear("t", "t"), y: linear("value", symbolOf(column, columns)), color, detail: { field: "parameter" }, order: { field: "t" } },
  });
  return {
    id: "family", title: `The solution over ${parameter}`, points, columns: ["parameter", "column", "t", "value"],
    spec: chart(`${title}: ${columns.join(", ")} against t for ${values.length} values of ${parameter}`, points, { vconcat: columns.map(panel) }),
  };
}

function familyPhases({ title, family }, wanted) {
  const { parameter, members } = family;
  const columns = wanted ?? members[0].solution.columns.slice(0, 2);
  const points = members.flatMap(({ value, solution }) => {
    const { values: [x, y] } = chosenPart(solution, columns);
    return solution.t.map((t, i) => ({ parameter: value, t, x: x[i], y: y[i] }));
  });
  const color = { field: "parameter", type: "ordinal", title: symbolOf(parameter), scale: { domain: members.map(({ value }) => value), scheme: "viridis", reverse: true }, legend: { orient: "right", symbolType: "stroke" } };
  return {
    id: "family-phase", title: `${columns[1]} against ${columns[0]} over ${parameter}`, points, columns: ["parameter", "t", "x", "y"],
    spec: chart(`${title}: ${columns[1]} against ${columns[0]}`, points, { mark: { type: "line", strokeWidth: 1 },
      encoding: { x: linear("x", symbolOf(columns[0], columns)), y: linear("y", symbolOf(columns[1], columns)), color, detail: { field: "parameter" }, order: { field: "t" } } }),
  };
}

const chartsOfFamily = (section, wanted) => (section.family ? [familyOverTime(section, wanted), ...(wanted?.length === 2 ? [familyPhases(section, wanted)] : [])] : []);
