// SPDX-License-Identifier: MIT
// A family of scenes: over a plane of two of its parameters, or of one and the accuracy, the line that is the cheapest.

// An axis is the index of a parameter, or this.
const accuracyAxis = -1, allValues = "all";
const axesOf = ({ parameters }) => [...parameters.keys(), accuracyAxis];
const nameOfAxis = ({ parameters }, axis) => parameters[axis] ?? "accuracy";

// The axes, and for every other parameter a value where it has one of its own: as the reader chooses them, at first the first two.
const firstPlane = ({ plane }) => ({ across: 0, up: axesOf(plane)[1], fixed: {} });

const accuracyOfFamily = ({ plane }, kind, { accuracy }) => (accuracy ? Number(accuracy) : plane.typical[kind.id]);
const robustnessOf = ({ plane }, kind, accuracy) => plane.robustness[kind.id].find((of) => of.accuracy === accuracy);
const distinct = (values) => [...new Set(values)].sort((a, b) => a - b);

// What is known of one scene to one accuracy.
function memberFacts(section, kind, place, member) {
  const { plane, accuracies } = section, cells = plane.cells[kind.id][place] ?? {}, best = plane.best[kind.id] ?? {};
  const of = (columns) => Object.fromEntries(Object.entries(columns).map(([name, column]) => [name, column[member]]).filter(([, value]) => value !== null));
  const { line, second, ties, options, scheme, ratio, ...run } = of(cells), nearest = of(best), name = (index) => plane.lines[index];
  const shared = { member, scene: plane.names[member], accuracy: accuracies[place], kind };
  if (line === undefined) return { ...shared, ...(nearest.line !== undefined && { best: { line: name(nearest.line), error: nearest.error } }) };
  return {
    ...shared, ...run, line: name(line), ...(second !== undefined && { second: { line: name(second), ratio } }), ...(ties && { ties: ties.map(name) }),
    scheme: plane.options[scheme], options: plane.options[options],
  };
}

// Drawn values have a mark each, or, where there are several scenes to a place, the middle of one of twenty classes.
const mostPlaces = 40, classes = 20;
function classOf(values) {
  const [low, high] = [Math.min(...values), Math.max(...values)], isLog = hasSizes(low, high), sign = low < 0 ? -1 : 1;
  const [to, from] = isLog ? [(value) => Math.log(sign * value), (at) => sign * Math.exp(at)] : [(value) => value, (at) => at];
  const [first, last] = [to(low), to(high)], width = (last - first) / classes;
  return (value) => Number(from(first + width * (Math.min(classes - 1, Math.floor((to(value) - first) / width)) + 0.5)).toPrecision(4));
}

// All cells of the plane: at each place the scenes that are there, one or several.
function cellsOfPlane(section, kind, view, chosen) {
  const { plane, accuracies } = section, { across, up, fixed } = chosen;
  const isElsewhere = (value, axis) => ![across, up].includes(axis) && fixed[axis] !== undefined && fixed[axis] !== value;
  const members = [...plane.names.keys()].filter((member) => !plane.values.some((values, axis) => isElsewhere(values[member], axis)));
  const overAccuracy = [across, up].includes(accuracyAxis);
  const places = overAccuracy ? accuracies.map((_, i) => i) : [accuracies.indexOf(accuracyOfFamily(section, kind, view))];
  const isOpen = overAccuracy ? plane.parameters.length > 1 : plane.parameters.length > 2;
  const classesOf = plane.values.map((values) => (isOpen && distinct(values).length > mostPlaces ? classOf(values) : (value) => value));
  const valueAt = (axis, member, place) => (axis === accuracyAxis ? accuracies[place] : classesOf[axis](plane.values[axis][member]));
  const cells = new Map();
  for (const place of places) {
    for (const member of members) {
      const [x, y] = [valueAt(across, member, place), valueAt(up, member, place)], key = `${x} ${y}`;
      if (!cells.has(key)) cells.set(key, { x, y, scenes: [] });
      cells.get(key).scenes.push(memberFacts(section, kind, place, member));
    }
  }
  return [...cells.values()];
}

// The most frequent winner of a cell with its share of the scenes; within noise where most of its wins are.
function winnerOf({ x, y, scenes }) {
  const solved = scenes.filter(({ line }) => line), counts = new Map();
  for (const { line } of solved) counts.set(line, (counts.get(line) ?? 0) + 1);
  const winners = [...counts].sort((a, b) => b[1] - a[1]).map(([line, count]) => ({ line, count, of: scenes.length }));
  if (winners.length === 0) return { x, y, scenes, winners, state: "none" };
  const [{ line, count }] = winners, its = solved.filter((scene) => scene.line === line), [{ seconds, second }] = its;
  const tied = its.filter(({ ties }) => ties).length;
  return {
    x, y, scenes, winners, line, state: 2 * tied > its.length ? "tie" : "clear", share: count / scenes.length,
    ...(scenes.length === 1 && { seconds, second: second?.line, times: second?.ratio }),
  };
}

// Whether values have one sign and several sizes.
const hasSizes = (first, last) => first * last > 0 && Math.max(Math.abs(first), Math.abs(last)) > 50 * Math.min(Math.abs(first), Math.abs(last));

// An axis: logarithmic where its values have one sign and several sizes, of their sizes where they are negative.
function axisOfValues(name, values) {
  const isLog = hasSizes(values[0], values.at(-1)), sign = values[0] < 0 ? -1 : 1;
  const place = (value) => (isLog ? sign * value : value), places = values.map(place).sort((a, b) => a - b);
  const middle = (a, b) => (isLog ? Math.sqrt(a * b) : (a + b) / 2);
  const mirrored = (at, from) => (isLog ? at * at / from : 2 * at - from);
  const edges = places.slice(1).map((at, i) => middle(places[i], at));
  const single = isLog ? [places[0] / 2, places[0] * 2] : [places[0] - 0.5, places[0] + 0.5];
  const bounds = places.length === 1 ? single : [mirrored(places[0], edges[0]), ...edges, mirrored(places.at(-1), edges.at(-1))];
  const from = new Map(places.map((at, i) => [at, [bounds[i], bounds[i + 1]]]));
  return { title: `${isLog && sign < 0 ? "−" : ""}${symbolOf(name)}`, isLog, place, places, bounds, from: (value) => from.get(place(value)) };
}

// With all cells of a lattice but a few the plane is shown as regions, otherwise as the points that were drawn.
const mostCells = 2500;
const isLattice = (cells, [across, up]) => 2 * cells.length > across.places.length * up.places.length && across.places.length * up.places.length <= mostCells;

const statesOfCells = { clear: "the cheapest", tie: "cheapest within noise of another", none: "no scheme gets there" };
function wordsOfCell({ x, y, state, line, winners, scenes }, plane, { across, up }) {
  const [{ accuracy, seconds, second, ties, best }] = scenes, words = { title: line ?? statesOfCells.none, [nameOfAxis(plane, across)]: String(x), [nameOfAxis(plane, up)]: String(y) };
  if (scenes.length > 1) {
    words.scenes = String(scenes.length);
    for (const { line: of, count } of winners) words[`cheapest: ${of}`] = String(count);
    return words;
  }
  if (![across, up].includes(accuracyAxis)) words.accuracy = fewDigits(accuracy);
  if (seconds) words.time = timeText(seconds);
  if (second) words.second = `${second.line}, × ${numberFormats.three(second.ratio)}`;
  if (state === "tie") words["within noise"] = ties.join(", ");
  if (best) words["smallest error"] = `${fewDigits(best.error)}, ${best.line}`;
  return words;
}

// wants: whether a line, and a session, is wanted.
function winnerMap(section, lines, kind, view, chosen, wants) {
  const { plane } = section, cells = cellsOfPlane(section, kind, view, chosen).map(winnerOf);
  const axes = ["x", "y"].map((field, i) => axisOfValues(nameOfAxis(plane, i ? chosen.up : chosen.across), distinct(cells.map((cell) => cell[field]))));
  const [across, up] = axes, regions = isLattice(cells, axes);
  const points = cells.map((cell, index) => {
    const [[left, right], [low, high]] = [across.from(cell.x), up.from(cell.y)], { scenes: [{ session }] } = cell;
    return {
      ...cell, index, left, right, low, high, atX: across.place(cell.x), atY: up.place(cell.y), faint: cell.line !== undefined && !wants(cell.line, session),
      words: wordsOfCell(cell, plane, chosen),
    };
  });
  const drawn = points.map(({ scenes, winners, ...point }) => ({ ...point, line: point.line ?? "" }));
  const side = Math.min(620 / across.places.length, 330 / up.places.length), size = regions ? Math.max(9, Math.min(60, (side * side) / 5)) : 40;
  const axis = ({ title, isLog, places, bounds }, field) => ({
    field, title, type: "quantitative",
    scale: { type: isLog ? "log" : "linear", nice: false, ...(!isLog && { zero: false }), domain: regions ? [bounds[0], bounds.at(-1)] : [places[0], places.at(-1)], ...(!regions && { padding: 14 }) },
    axis: { labelOverlap: true, labelFlush: false, grid: false, ...(isLog ? { labelExpr: labels.number, values: ticks(places) } : regions && { values: places }) },
  });
  const { colour: { color }, shape: { shape } } = lineChannels(lines, points);
  const opacity = (clear, tie) => ({ condition: [{ test: "datum.faint", value: 0.08 }, { test: "datum.state === 'tie'", value: tie }], ...clear });
  const tooltip = { expr: "datum.words" }, xy = { x: axis(across, "atX"), y: axis(up, "atY") };
  const [won, none] = [{ filter: "datum.state !== 'none'" }, { filter: "datum.state === 'none'" }];
  const layer = [
    ...(regions ? [{ transform: [won], mark: { type: "rect", tooltip, cursor: "pointer" }, encoding: { x: axis(across, "left"), x2: { field: "right" }, y: axis(up, "low"), y2: { field: "high" }, color, opacity: opacity({ field: "share", type: "quantitative", scale: { domain: [0, 1], range: [0.1, 0.45] }, legend: null }, 0.14) } }] : []),
    ...["clear", "tie"].map((state) => ({
      transform: [{ filter: `datum.state === '${state}'` }], mark: { type: "point", filled: state === "clear", size, strokeWidth: 1.3, tooltip, cursor: "pointer" },
      encoding: { ...xy, color, shape, opacity: opacity({ value: 1 }, 1) },
    })),
    { transform: [none], mark: { type: "text", text: "×", fontSize: Math.max(10, Math.sqrt(size) + 4), color: ofPage("--quiet"), tooltip, cursor: "pointer" }, encoding: xy },
  ];
  const toAccuracy = [chosen.across, chosen.up].includes(accuracyAxis) ? "" : `, to ${numberFormats.power(accuracyOfFamily(section, kind, view))}`;
  const [nameAcross, nameUp] = [chosen.across, chosen.up].map((axis) => nameOfAxis(plane, axis)), several = points.some(({ scenes }) => scenes.length > 1);
  return {
    id: "winners", points, columns: ["x", "y", "line", "share", "state", "seconds", "second", "times"],
    titles: { x: nameAcross, y: nameUp, line: "cheapest" },
    title: `The cheapest scheme over ${nameAcross} and ${nameUp}${toAccuracy}`,
    note: [several ? "A cell is of several scenes: it shows the scheme that is most often the cheapest, the paler the fewer they are." : regions ? "Each cell is a scene." : "Each mark is a scene that was drawn.",
      "Hollow marks: another scheme is within the noise of the times. ×: no scheme gets there. A click shows the run and its command."].join(" "),
    opens: ({ scenes: [first], scenes, winners, line }) => ({ line, facts: scenes.length === 1 ? first : { kind, accuracy: first.accuracy, several: scenes.length, winners, line } }),
    spec: chart(`${section.title}: the cheapest scheme over ${nameAcross} and ${nameUp}, a colour and a mark for each`, drawn, { height: 360, resolve: { scale: { x: "shared", y: "shared" } }, layer }),
  };
}

// The choice of the axes, and of the values of the other parameters; `choose` is called with each.
function planeControls({ plane }, chosen, choose) {
  const { across, up, fixed } = chosen;
  const select = (name, text, options, now, chosenBy) => {
    const made = element("select", { name }, ...options.map(([value, label]) => element("option", { value, ...(String(value) === String(now) && { selected: "" }) }, label)));
    made.addEventListener("change", () => choose({ ...chosen, ...chosenBy(made.value) }, name));
    return element("label", {}, `${text} `, made);
  };
  const axes = axesOf(plane).map((axis) => [axis, nameOfAxis(plane, axis)]);
  const axisChosen = (mine, other) => (value) => ({ [mine]: Number(value), ...(Number(value) === chosen[other] && { [other]: chosen[mine] }) });
  const rest = [...plane.parameters.entries()].filter(([axis]) => axis !== across && axis !== up).map(([axis, name]) =>
    select(`fixed-${axis}`, name, [[allValues, "all: the most frequent winner"], ...distinct(plane.values[axis]).map((value) => [value, String(value)])], fixed[axis] ?? allValues,
      (value) => ({ fixed: { ...fixed, [axis]: value === allValues ? undefined : Number(value) } })));
  return element("form", { class: "plane", autocomplete: "off", "aria-label": "Axes of the map" },
    select("across", "Across", axes, across, axisChosen("across", "up")), select("up", "up", axes, up, axisChosen("up", "across")), ...rest);
}
