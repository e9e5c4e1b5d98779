// The charts of a section, each { id, title, points, columns, spec }: the columns are those of its table.

function errorAgainstTime(scene, lines, kind) {
  const points = scene.points.filter((point) => point.error && point.seconds);
  const encoding = { x: logAxis(points, "seconds", "run time", labels.time), y: logAxis(points, "error", kind.title, labels.number) };
  return {
    id: "error-against-time", title: "Error against run time", points, columns: ["line", "steps", "asked", "seconds", "error"],
    spec: chart(`${scene.title}: ${kind.title} against run time, a line for each scheme`, points,
      { layer: lineLayers(encoding, lines, points) }),
  };
}

// Dashed lines have the slope that theory promises. A scheme that chooses its steps has no step to speak of.
function errorAgainstStep(scene, lines, kind) {
  const points = scene.points.filter((point) => point.error && !point.asked);
  const encoding = { x: logAxis(points, "h", "step h", labels.number), y: logAxis(points, "error", kind.title, labels.number) };
  const guides = {
    data: { values: scene.guides.filter((guide) => guide.kind === kind.id) },
    mark: { type: "line", strokeDash: [4, 4], strokeWidth: 1 }, encoding: { ...encoding, ...lineChannels(lines, points).colour },
  };
  return {
    id: "error-against-step", title: "Error against step; dashed: theoretical rate", points, columns: ["line", "steps", "h", "error"],
    spec: chart(`${scene.title}: ${kind.title} against step, a line for each scheme and dashed its theoretical rate`, points,
      { layer: [guides, ...lineLayers(encoding, lines, points)] }),
  };
}

// On the diagonal a scheme delivers what it is asked for; the band is within a factor of ten.
function deliveredAgainstAsked(scene, lines, kind) {
  const points = scene.points.filter((point) => point.error && point.asked);
  const ends = [Math.min, Math.max].map((end) => end(...points.map((point) => point.asked)));
  const diagonal = { values: ends.map((error) => ({ asked: error, error, low: error / 10, high: error * 10 })) };
  const all = [...points, ...diagonal.values.map(({ asked, low, high }, end) => ({ asked, error: end ? high : low }))];
  const both = { x: logAxis(all, "asked", "accuracy asked", labels.number), y: logAxis(all, "error", `${kind.title} delivered`, labels.number) };
  const mark = { color: ofPage("--quiet"), tooltip: false, clip: true };
  const guides = [
    { data: diagonal, mark: { ...mark, type: "area", opacity: 0.15 }, encoding: { x: both.x, y: { ...both.y, field: "low" }, y2: { field: "high" } } },
    { data: diagonal, mark: { ...mark, type: "line", strokeDash: [4, 4], strokeWidth: 1 }, encoding: both },
  ];
  return {
    id: "delivered-against-asked", title: "Accuracy delivered against asked; band: a factor of ten", points,
    columns: ["line", "asked", "error", "ratio", "steps", "seconds"], open: true,
    spec: chart(`${scene.title}: ${kind.title} delivered against accuracy asked, a line for each scheme that takes one`, points,
      { layer: [...guides, ...lineLayers(both, lines, points, "asked")] }),
  };
}

function energyAgainstStep(scene, lines) {
  const points = scene.points.filter((point) => point.energy && !point.asked);
  const encoding = { x: logAxis(points, "h", "step h", labels.number), y: logAxis(points, "energy", "energy residual", labels.number) };
  return {
    id: "energy-against-step", title: "Residual of the energy balance against step", points, columns: ["line", "steps", "h", "energy"],
    spec: chart(`${scene.title}: largest residual of the energy balance against step, a line for each scheme`, points,
      { layer: lineLayers(encoding, lines, points) }),
  };
}

// What is named by a field, over the parameter of the section.
function overParameter(field, labelExpr, nameOf) {
  return (section, lines, kind) => {
    const name = nameOf(kind);
    const points = section.points.filter((point) => point[field]);
    const encoding = { x: parameterAxis(points, section.parameter), y: logAxis(points, field, name, labelExpr) };
    return {
      id: `${field}-over-parameter`, columns: ["line", "value", "steps", field], title: `${name[0].toUpperCase()}${name.slice(1)} over ${section.parameter}`, points,
      spec: chart(`${section.title}: ${name}, a line for each scheme`, points, { layer: lineLayers(encoding, lines, points, "value") }),
    };
  };
}

const chartsOfScenes = [errorAgainstTime, errorAgainstStep, deliveredAgainstAsked, energyAgainstStep];
const chartsOfCurves = [
  overParameter("error", labels.number, (kind) => kind.title), overParameter("seconds", labels.time, () => "run time"),
];

// What a point's tooltip says of its errors of all kinds: 1.2e-7.
const errorWords = ({ errors }, kinds) =>
  kinds.filter(({ id }) => errors[id]).map(({ id, title }) => [title, errors[id].toExponential(1)]);

// The charts of a scene, or over a parameter, that have points, as { title, spec }, with errors of this kind.
function chartsOf(scene, lines, kind, kinds) {
  const drawn = { ...scene, points: scene.points.map((point) =>
    ({ ...point, error: point.errors[kind.id], ratio: point.errors[kind.id] / point.asked, words: Object.fromEntries([...point.words, ...errorWords(point, kinds)]) })) };
  return (scene.parameter ? chartsOfCurves : chartsOfScenes)
    .map((make) => make(drawn, lines, kind)).filter((made) => made.points.length > 0);
}
