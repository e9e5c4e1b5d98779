// SPDX-License-Identifier: MIT
// Names beside the lines of a chart, where each covers least of what is drawn and is farthest from other lines: readers need not match colours with a legend.

const mostLabels = 8;

// In pixels: about what a chart is inside its axes, and its letters. Figures for papers have others.
let labelFrame = { width: 430, height: 270, letters: 11 };

const axisPadding = 14;
function pixelsOf({ field, scale }, drawn, length) {
  const to = scale.type === "log" ? Math.log : Number, values = drawn.map((point) => to(point[field])).filter(Number.isFinite);
  const [low, high] = [Math.min(...values), Math.max(...values)], part = high > low ? (length - 2 * axisPadding) / (high - low) : 0;
  return (point) => axisPadding + (to(point[field]) - low) * part;
}

// Places on a line, at most `gap` pixels apart.
function tracedLine(places, gap = 4) {
  return places.flatMap((to, i) => {
    const from = places[i - 1] ?? to, count = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / gap));
    return Array.from({ length: count }, (_, part) => ({ x: to.x + ((from.x - to.x) * part) / count, y: to.y + ((from.y - to.y) * part) / count }));
  });
}

const labelSides = [{ align: "left", dx: 7, dy: 0 }, { align: "right", dx: -7, dy: 0 }, { align: "center", dx: 0, dy: -10 }, { align: "center", dx: 0, dy: 10 },
  { align: "left", dx: 5, dy: -9 }, { align: "left", dx: 5, dy: 9 }, { align: "right", dx: -5, dy: -9 }, { align: "right", dx: -5, dy: 9 }];
function boxAt({ x, y }, { align, dx, dy }, width, height) {
  const left = x + dx - (align === "left" ? 0 : align === "right" ? width : width / 2), top = y + dy - height / 2;
  return { left, top, right: left + width, bottom: top + height };
}
const isWithin = ({ x, y }, { left, top, right, bottom }, margin) => x >= left - margin && x <= right + margin && y >= top - margin && y <= bottom + margin;
const areMet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

// One label a line, { line, name, align, dx, dy } and a place of the line. drawn: all points in the chart, which give its axes their ends.
function labelsOf({ x, y }, lines, points, drawn) {
  const { width, height, letters } = labelFrame, [across, up] = [pixelsOf(x, drawn, width), pixelsOf(y, drawn, height)];
  const placed = points.map((point) => ({ point, x: across(point), y: height - up(point) }));
  const placesOf = new Map(lines.map((line) => [line, placed.filter(({ point }) => point.line === line)])), taken = [];
  const traces = new Map(lines.map((line) => [line, tracedLine(placesOf.get(line))])), all = [...traces.values()].flat();
  return lines.map((line) => {
    const places = placesOf.get(line), name = nameOf(line), breadth = 0.56 * letters * name.length, others = lines.flatMap((other) => (other === line ? [] : traces.get(other)));
    const costOf = (place, at, side) => {
      const box = boxAt(place, side, breadth, letters);
      const isOut = box.left < 0 || box.right > width || box.top < 0 || box.bottom > height;
      const covered = all.filter((of) => isWithin(of, box, 0)).length, near = others.filter((of) => isWithin(of, box, 8)).length;
      return 1000 * isOut + 300 * taken.filter((other) => areMet(box, other)).length + 4 * covered + near + (at > 0 && at < places.length - 1);
    };
    const choices = places.flatMap((place, at) => labelSides.map((side) => ({ place, side, cost: costOf(place, at, side) })));
    const { place, side } = choices.reduce((least, choice) => (choice.cost < least.cost ? choice : least));
    taken.push(boxAt(place, side, breadth, letters));
    return { line, name, ...side, [x.field]: place.point[x.field], [y.field]: place.point[y.field] };
  });
}

// The chart with labels at its lines, where these are a few or `always`. Labels that it has already are made anew.
function withLineLabels({ spec, points, ...made }, lines, always = false) {
  const layer = spec.layer?.filter(({ name }) => name !== "labels"), named = lines.filter((line) => points.some((point) => point.line === line));
  const marks = layer?.find(({ mark, encoding }) => mark.type === "point" && encoding?.color?.field === "line");
  if (!marks || named.length < 2 || (named.length > mostLabels && !always)) return { ...made, points, spec: layer ? { ...spec, layer } : spec };
  const { x, y, color, opacity } = marks.encoding, drawn = [...points, ...layer.flatMap(({ data }) => data?.values ?? [])];
  const expressions = Object.fromEntries(["align", "dx", "dy"].map((name) => [name, { expr: `datum.${name}` }]));
  const labels = {
    name: "labels", data: { values: labelsOf({ x, y }, named, points, drawn) }, mark: { type: "text", baseline: "middle", fontSize: labelFrame.letters, tooltip: null, ...expressions },
    encoding: { x, y, color, opacity, text: { field: "name" } },
  };
  return { ...made, points, spec: { ...spec, layer: [...layer, withLabels(labels)] } };
}
