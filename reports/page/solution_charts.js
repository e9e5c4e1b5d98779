// What is known of a scene's solution: its columns against t, and one against another.

const solutionRows = ({ t, columns, values }) =>
  columns.flatMap((column, c) => t.map((time, i) => ({ t: time, column, value: values[c][i] })));

// x against its rate, where the rate is a column; otherwise the first column against the second.
function portraitOf({ columns }) {
  const rate = columns.indexOf(`d${columns[0]}`);
  return columns.length < 2 ? null : [0, rate > 0 ? rate : 1];
}

const linear = (field, title) => ({ field, title, type: "quantitative", scale: { zero: false, nice: false, padding: 6 } });

function solutionOverTime(section) {
  const { columns, bound } = section.solution;
  const points = solutionRows(section.solution);
  const color = { field: "column", type: "nominal", scale: { domain: columns, range: columns.map((_, i) => colours[i % colours.length]) },
    legend: columns.length > 1 ? { orient: "bottom", title: null } : null };
  return {
    id: "solution", title: `The solution, known to ${fewDigits(bound)}`, points, columns: ["column", "t", "value"],
    spec: chart(`${section.title}: the reference solution, ${columns.join(", ")} against t`, points, {
      mark: { type: "line", strokeWidth: 1.5 },
      encoding: { x: linear("t", "t"), y: linear("value", columns.length > 1 ? "columns" : columns[0]), color, detail: { field: "column" }, order: { field: "t" } },
    }),
  };
}

function phasePortrait(section) {
  const place = portraitOf(section.solution);
  if (!place) return { points: [] };
  const { t, columns, values } = section.solution;
  const [x, y] = place;
  const points = t.map((time, i) => ({ t: time, x: values[x][i], y: values[y][i] }));
  return {
    id: "phase-portrait", title: `${columns[y]} against ${columns[x]}; the dot: t = 0`, points, columns: ["t", "x", "y"],
    spec: chart(`${section.title}: phase portrait, ${columns[y]} against ${columns[x]}`, points, {
      encoding: { x: linear("x", columns[x]), y: linear("y", columns[y]) },
      layer: [
        { mark: { type: "line", strokeWidth: 1.2, color: colours[0] }, encoding: { order: { field: "t" } } },
        { data: { values: points.slice(0, 1) }, mark: { type: "point", filled: true, size: 60, color: colours[1] } },
      ],
    }),
  };
}

const chartsOfSolution = (section) =>
  section.solution ? [solutionOverTime(section), phasePortrait(section)].filter(({ points }) => points.length > 0) : [];
