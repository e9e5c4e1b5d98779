// SPDX-License-Identifier: MIT
// The charts of a section, each { id, title, points, columns, spec }: the columns are those of its table.

// The points that no other beats in both, by increasing cost.
function paretoFront(points, cost) {
  const front = [];
  for (const point of [...points].sort((a, b) => a[cost] - b[cost] || a.error - b.error)) {
    if (front.length === 0 || point.error < front.at(-1).error) front.push(point);
  }
  return front;
}

// The lines that are on the front of error against time, the most frequent first, then by how many times as long the points of a line take, in
// the median, as what is at least as accurate.
function linesByTime(points) {
  const timed = points.filter(({ error, time_minimum }) => error && time_minimum), front = paretoFront(timed, "time_minimum");
  const middle = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? Infinity;
  const leastTime = (error) => front.find((point) => point.error <= error).time_minimum;
  const rankOf = (line) => ({
    line, won: front.filter((point) => point.line === line).length,
    behind: middle(timed.filter((point) => point.line === line).map(({ time_minimum, error }) => time_minimum / leastTime(error))),
  });
  return [...new Set(points.map(({ line }) => line))].map(rankOf).sort((a, b) => b.won - a.won || a.behind - b.behind).map(({ line }) => line);
}

// Of a scene with more lines than can be told apart its charts begin with those that are first by time.
const mostLines = 6, firstLines = 5;

// A cost is a field of the points, what it is called and how its axis is labelled.
function errorAgainstCost(scene, lines, kind, { id, field, name, labelExpr, least }) {
  const points = scene.points.filter((point) => point.error && point[field]);
  const encoding = { x: logAxis(points, field, name, labelExpr), y: logAxis(points, "error", titleOfKind(kind), labels.number) };
  const front = {
    name: "pareto-front", data: { values: paretoFront(scene.all_points.filter((point) => point.error && point[field]), field).map((point) => ({ [field]: point[field], error: point.error })) },
    mark: { type: "line", interpolate: "step-after", strokeWidth: 9, strokeJoin: "round", strokeCap: "round", opacity: 0.16, color: ofPage("--text"), tooltip: false }, encoding,
  };
  return {
    id, title: `Error against ${name}; band: nothing is ${least} and more accurate`, points, columns: ["line", "steps", "requested", field, "error"],
    spec: chart(`${scene.title}: ${titleOfKind(kind)} against ${name}, a line for each scheme`, points,
      { layer: [front, ...lineLayers(encoding, lines, points)] }),
  };
}

const errorAgainstTime = (scene, lines, kind) => errorAgainstCost(scene, lines, kind,
  { id: "error-against-time", field: "time_minimum", name: "run time", labelExpr: labels.time, least: "quicker" });

const errorAgainstMemory = (scene, lines, kind) => errorAgainstCost(scene, lines, kind,
  { id: "error-against-memory", field: "history_bytes", name: "memory of the history", labelExpr: labels.bytes, least: "smaller" });

// Dotted lines have the slope that theory promises. A scheme that chooses its steps has no step to speak of.
function errorAgainstStep(scene, lines, kind) {
  const points = scene.points.filter((point) => point.error && !point.requested);
  const encoding = { x: logAxis(points, "h", "step h", labels.number), y: logAxis(points, "error", titleOfKind(kind), labels.number) };
  const guides = {
    data: { values: guidesOf(points, scene.rates, kind) },
    mark: { type: "line", strokeDash: [1, 3], strokeWidth: 1 }, encoding: { ...encoding, ...lineChannels(lines, points).colour },
  };
  return {
    id: "error-against-step", title: "Error against step; dotted: theoretical rate", points, columns: ["line", "steps", "h", "error"],
    spec: chart(`${scene.title}: ${titleOfKind(kind)} against step, a line for each scheme and dotted its theoretical rate`, points,
      { layer: [...(guides.data.values.length > 0 ? [guides] : []), ...lineLayers(encoding, lines, points)] }),
  };
}

// On the diagonal a scheme delivers the requested accuracy; the band is within a factor of ten.
function deliveredAgainstRequested(scene, lines, kind) {
  const points = scene.points.filter((point) => point.error && point.requested);
  const ends = [Math.min, Math.max].map((end) => end(...points.map((point) => point.requested)));
  const diagonal = { values: ends.map((error) => ({ requested: error, error, low: error / 10, high: error * 10 })) };
  const all = [...points, ...diagonal.values.map(({ requested, low, high }, end) => ({ requested, error: end ? high : low }))];
  const both = { x: logAxis(all, "requested", "requested accuracy", labels.number), y: logAxis(all, "error", `${titleOfKind(kind)} delivered`, labels.number) };
  const mark = { color: ofPage("--quiet"), tooltip: false, clip: true };
  const guides = [
    { data: diagonal, mark: { ...mark, type: "area", opacity: 0.15 }, encoding: { x: both.x, y: { ...both.y, field: "low" }, y2: { field: "high" } } },
    { data: diagonal, mark: { ...mark, type: "line", strokeDash: [4, 4], strokeWidth: 1 }, encoding: both },
  ];
  return {
    id: "delivered-against-requested", title: "Delivered against requested accuracy; band: a factor of ten", points,
    columns: ["line", "requested", "error", "ratio", "steps", "time_minimum"], open: true,
    spec: chart(`${scene.title}: ${titleOfKind(kind)} delivered against accuracy requested, a line for each scheme that takes one`, points,
      { layer: [...guides, ...lineLayers(both, lines, points, "requested")] }),
  };
}

function energyAgainstStep(scene, lines) {
  const points = scene.points.filter((point) => point.energy_residual && !point.requested);
  const encoding = { x: logAxis(points, "h", "step h", labels.number), y: logAxis(points, "energy_residual", "energy residual", labels.number) };
  return {
    id: "energy-against-step", title: "Residual of the energy balance against step", points, columns: ["line", "steps", "h", "energy_residual"],
    spec: chart(`${scene.title}: largest residual of the energy balance against step, a line for each scheme`, points,
      { layer: lineLayers(encoding, lines, points) }),
  };
}

// What is named by a field, over the parameter of the section.
function overParameter(id, field, labelExpr, nameOf) {
  return (section, lines, kind) => {
    const name = nameOf(kind);
    const points = section.points.filter((point) => point[field]);
    const encoding = { x: parameterAxis(points, section.parameter), y: logAxis(points, field, name, labelExpr) };
    return {
      id, title: `${name[0].toUpperCase()}${name.slice(1)} over ${section.parameter}`, points, columns: ["line", "value", "steps", field],
      spec: chart(`${section.title}: ${name}, a line for each scheme`, points, { layer: lineLayers(encoding, lines, points, "value") }),
    };
  };
}

const chartsOfScenes = [errorAgainstTime, errorAgainstStep, errorAgainstMemory, deliveredAgainstRequested, energyAgainstStep];
const chartsOfCurves = [
  overParameter("error-over-parameter", "error", labels.number, titleOfKind), overParameter("time-over-parameter", "time_minimum", labels.time, () => "run time"),
];

// The points of a section that are wanted, with errors of this kind.
const wantedPoints = (section, kind, kinds, wants) => pointsOf(section, kind, kinds).filter(({ line, session }) => wants(line, session));

// The charts of a scene, or over a parameter, that have points. first_lines: of many lines those that are drawn.
function chartsOf(scene, lines, kindOfPage, kinds, wants) {
  const kind = scene.compared_columns ? { ...kindOfPage, columns: scene.compared_columns } : kindOfPage;
  const all_points = wantedPoints(scene, kind, kinds, wants);
  const drawn = { ...scene, all_points, points: all_points.filter(({ line }) => scene.first_lines?.includes(line) ?? true) };
  return (scene.parameter ? chartsOfCurves : chartsOfScenes)
    .map((make) => make(drawn, lines, kind)).filter((made) => made.points.length > 0).map((made) => withLineLabels(made, lines));
}

// All charts that a section has, of what is measured and of what is known.
function chartsOfSection(section, lines, kind, kinds, wants, columns) {
  return [
    ...(section.runs ? chartsOf(section, lines, kind, kinds, wants) : []),
    ...(section.regions ? [stabilityRegions(section, lines, wants)] : []),
    ...(section.drifts ?? []).flatMap((drift) => chartsOfDrift(drift, wants)),
    ...chartsOfSolution(section, columns),
    ...chartsOfFamily(section, columns),
  ];
}
