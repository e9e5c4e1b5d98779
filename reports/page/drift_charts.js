// SPDX-License-Identifier: MIT
// How far the formulations of a scene stray from its constraints: a colour for each formulation, and a shape and dashes for each scheme;
// with one formulation a colour for each scheme.

function driftChannels(points) {
  const channel = (field, values, ofLine) => {
    const names = [...new Set(points.map((point) => point[field]))];
    const range = ofLine && field === "line" ? names.map((line) => ofLine(names, line)) : values;
    const legend = names.length > 1 ? { orient: "bottom", title: null, symbolOpacity: 1, labelLimit: 260, ...(ownNames.size > 0 && { labelExpr: namesInLegend(names) }), columns: { expr: "clamp(floor(containerSize()[0] / 200), 1, 3)" } } : null;
    return { field, type: "nominal", scale: { domain: names, range: names.map((_, i) => range[i % range.length]) }, legend };
  };
  const count = (field) => new Set(points.map((point) => point[field])).size;
  if (count("formulation") < 2) return { color: channel("line", colours, colourOf), shape: channel("line", shapes, shapeOf), strokeDash: channel("line", dashes) };
  const by = count("line") > 1 ? "line" : "formulation";
  return { color: channel("formulation", colours), shape: channel(by, shapes, shapeOf), strokeDash: channel(by, dashes) };
}

const wordsOfDrift = ({ formulation, line, steps, h, t, drift }) => ({
  title: [formulation, line].filter(Boolean).join(", "), N: String(steps), ...(h && { h: String(Number(h.toPrecision(3))) }), ...(t && { t: String(t) }), drift: fewDigits(drift),
});

function driftChart(id, title, description, field, of, points) {
  const labelled = points.map((point) => ({ ...point, words: wordsOfDrift(point) }));
  if (labelled.length === 0) return null;
  const { color, shape, strokeDash } = driftChannels(labelled);
  const encoding = { x: logAxis(labelled, field, of, labels.number), y: logAxis(labelled, "drift", "drift", labels.number), color, detail: [{ field: "line" }, { field: "formulation" }] };
  return {
    id, title, points: labelled, columns: ["formulation", "line", "steps", "h", "t", "drift"],
    spec: chart(description, labelled, { layer: [
      { mark: { type: "line", strokeWidth: 1, opacity: 0.7 }, encoding: { ...encoding, strokeDash, order: { field } } },
      { mark: { type: "point", filled: true, size: 30, tooltip: { expr: "datum.words" } }, encoding: { ...encoding, shape } },
    ] }),
  };
}

const pointsOfDrift = ({ formulations, lines, formulation = [], line, steps, h, drift }) =>
  formulation.map((place, i) => ({ formulation: formulations[place], line: lines[line[i]], steps: steps[i], h: h[i], drift: drift[i] }));

// Of a scene: against the step by the runs, against time by the run of each formulation that is best within a common time.
function chartsOfDrift({ title, points, courses }, wants) {
  const overTime = courses.filter(({ line }) => wants(line)).flatMap(({ t, drift, ...of }) => t.map((time, i) => ({ ...of, t: time, drift: drift[i] })));
  return [
    driftChart("drift-against-step", `${title}: drift against step`, `${title}: largest drift from the constraints against the step, a line for each scheme in the colour of its formulation`, "h", "step h", pointsOfDrift(points).filter(({ line }) => wants(line))),
    driftChart("drift-over-time", `${title}: drift up to t, the best run of each`, `${title}: largest drift up to t, a line for each formulation`, "t", "t", overTime),
  ].filter(Boolean);
}
