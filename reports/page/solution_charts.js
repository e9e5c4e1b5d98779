// SPDX-License-Identifier: MIT
// What is known of a scene's solution: its columns against t, one against another, its energy, the reactions of its constraints.

const rowsOfColumns = ({ columns, values }, times) =>
  columns.flatMap((column, c) => times.map((t, i) => ({ t, column, value: values[c][i] }))).filter(({ value }) => value !== null);

// x against its rate, where the rate is a column; otherwise the first column against the second.
function portraitOf(columns) {
  const rate = columns.indexOf(`d${columns[0]}`);
  return columns.length < 2 ? null : [0, rate > 0 ? rate : 1];
}

// Names of columns as symbols: phi, dphi, Dbeta_phi are φ, φ′, Dᵝφ; a name of one's own stands for one column alone.
const letters = new Map(Object.entries({ alpha: "α", beta: "β", gamma: "γ", lambda: "λ", mu: "μ", nu: "ν", omega: "ω", phi: "φ", psi: "ψ", theta: "θ", xi: "ξ" }));
const raised = { alpha: "ᵅ", beta: "ᵝ" };
const symbolOf = (name, columns = []) => (ownNames.has(name) ? nameOf(name) : greekOf(name, columns));
function greekOf(name, columns = []) {
  const [, order, of] = /^D(alpha|beta)_(\w+)$/.exec(name) ?? [];
  if (order) return `D${raised[order]}${greekOf(of)}`;
  if (name.length > 1 && name.startsWith("d") && columns.includes(name.slice(1))) return `${greekOf(name.slice(1))}′`;
  const [, word, index] = /^(.*?)(\d?)$/s.exec(name);
  return (letters.get(word) ?? word) + (index && String.fromCharCode(0x2080 + Number(index)));
}
const symbolLabels = (columns) => namesInLegend(columns, (name) => symbolOf(name, columns));

// Of the time without padding, which on a narrow axis would reach to ticks below 0.
const linear = (field, title) => ({ field, title, type: "quantitative", scale: { zero: false, nice: false, padding: field === "t" ? 0 : 6 }, axis: { tickCount: 7, labelOverlap: true } });

// Colours and dashes: curves are distinguished on paper without colours too.
const dashes = [[], [6, 3], [2, 2], [8, 3, 2, 3], [1, 3], [10, 4]];
function columnChannels(columns) {
  const legend = columns.length > 1 ? { orient: "bottom", title: null, symbolType: "stroke", symbolSize: 260, symbolStrokeWidth: 1.5, labelExpr: symbolLabels(columns) } : null;
  const scale = (range) => ({ domain: columns, range: columns.map((_, i) => range[i % range.length]) });
  return {
    color: { field: "column", type: "nominal", scale: scale(colours), legend },
    strokeDash: { field: "column", type: "nominal", scale: scale(dashes), legend },
  };
}

function againstTime(section, part, id, title, description) {
  const points = rowsOfColumns(part, section.solution.t);
  const { columns } = part;
  return {
    id, title, points, columns: ["column", "t", "value"],
    spec: chart(`${section.title}: ${description}`, points, {
      mark: { type: "line", strokeWidth: 1.5 },
      encoding: { x: linear("t", "t"), y: linear("value", columns.length > 1 ? "" : symbolOf(columns[0], columns)), ...columnChannels(columns),
        detail: { field: "column" }, order: { field: "t" } },
    }),
  };
}

// The columns that are wanted, of all that is known over time.
function chosenPart({ columns, values, energy, reactions, motion }, wanted) {
  const all = [{ columns, values }, energy, reactions, motion].filter((part) => part?.values);
  const found = wanted.map((name) => {
    const part = all.find((one) => one.columns.includes(name));
    if (!part) throw new Error(`--columns: ${name} is none of ${[...new Set(all.flatMap((one) => one.columns))].join(", ")}`);
    return part.values[part.columns.indexOf(name)];
  });
  return { columns: wanted, values: found };
}

function solutionOverTime(section, wanted) {
  const { solution } = section;
  const part = wanted ? chosenPart(solution, wanted) : solution;
  return againstTime(section, part, "solution", `The solution, known to ${fewDigits(solution.bound)}`, `the reference solution, ${part.columns.join(", ")} against t`);
}

// Whether there is something to see: not where all values are one to the digits that are kept.
const varies = (values) => Math.max(...values) - Math.min(...values) > 2e-4 * Math.max(...values.map(Math.abs));

const energyOverTime = (section) => section.solution.energy && varies(section.solution.energy.values[0]) &&
  againstTime(section, section.solution.energy, "energy-over-time", "The energy of the solution", "the energy of the reference solution against t");

const reactionsOverTime = (section) => section.solution.reactions &&
  againstTime(section, section.solution.reactions, "multipliers", "The multipliers of the constraints", "the multipliers of its constraints against t");

// One curve in the plane, a dot at its start if that is known.
function curve(points, x, y) {
  const start = points.slice(0, 1).filter((point) => point.x !== null && point.y !== null);
  return {
    encoding: { x, y },
    layer: [
      { mark: { type: "line", strokeWidth: 1.2, color: colours[0] }, encoding: { order: { field: "t" } } },
      ...(start.length > 0 ? [{ data: { values: start }, mark: { type: "point", filled: true, size: 60, color: colours[1] } }] : []),
    ],
  };
}

function phasePortrait(section, wanted) {
  const { t } = section.solution;
  const { columns, values } = wanted ? chosenPart(section.solution, wanted) : section.solution;
  const place = wanted ? [0, 1] : portraitOf(columns);
  if (!place) return null;
  const [x, y] = place;
  if (!varies(values[x]) || !varies(values[y])) return null;
  const points = t.map((time, i) => ({ t: time, x: values[x][i], y: values[y][i] }));
  return {
    id: "phase-portrait", title: `${symbolOf(columns[y], columns)} against ${symbolOf(columns[x], columns)}; the dot: t = 0`, points, columns: ["t", "x", "y"],
    spec: chart(`${section.title}: phase portrait, ${columns[y]} against ${columns[x]}`, points, curve(points, linear("x", symbolOf(columns[x], columns)), linear("y", symbolOf(columns[y], columns)))),
  };
}

const chartsOfSolution = (section, wanted) =>
  section.solution ? [solutionOverTime(section, wanted), phasePortrait(section, wanted?.length === 2 ? wanted : undefined), motionOf(section), energyOverTime(section),
    reactionsOverTime(section)].filter((made) => made && made.points.length > 0) : [];
