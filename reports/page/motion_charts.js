// SPDX-License-Identifier: MIT
// The path of a motion: in the plane as it is, in space as seen from aside, on the sphere where it stays on one.

// The same length has the same size on both axes: a square of the larger extent.
function squareAxes(points, titles) {
  const extent = (name) => [Math.min, Math.max].map((end) => end(...points.map((point) => point[name])));
  const [x, y] = ["x", "y"].map(extent);
  const size = 1.08 * Math.max(x[1] - x[0], y[1] - y[0]) || 1;
  const axis = (name, [low, high], axisOf) => ({ field: name, type: "quantitative", title: titles[name],
    scale: { domain: [(low + high - size) / 2, (low + high + size) / 2], nice: false, zero: false }, ...axisOf });
  return { x: axis("x", x, titles.x ? {} : { axis: null }), y: axis("y", y, titles.x ? {} : { axis: null }) };
}

// The longitude around which a path on the sphere lies.
function middleOf(points) {
  const [x, y] = ["x", "y"].map((name) => points.reduce((sum, point) => sum + point[name], 0));
  return Math.atan2(y, x);
}

// As seen from there: across, upwards, towards the eye.
function seenFrom(azimuth, elevation) {
  const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
  return ({ x, y, z, ...rest }) => {
    const forward = ca * x + sa * y;
    return { ...rest, x: ca * y - sa * x, y: ce * z - se * forward, towards: ce * forward + se * z };
  };
}

const circle = (at) => Array.from({ length: 73 }, (_, i) => at((i * Math.PI) / 36));
function net() {
  const degrees = (step, first, last) => Array.from({ length: (last - first) / step + 1 }, (_, i) => ((first + i * step) * Math.PI) / 180);
  const parallels = degrees(30, -60, 60).map((latitude) => circle((phi) => ({ x: Math.cos(latitude) * Math.cos(phi), y: Math.cos(latitude) * Math.sin(phi), z: Math.sin(latitude) })));
  const meridians = degrees(30, 0, 150).map((longitude) => circle((phi) => ({ x: Math.cos(phi) * Math.cos(longitude), y: Math.cos(phi) * Math.sin(longitude), z: Math.sin(phi) })));
  return [...parallels, ...meridians];
}

// The stretches of a curve on one side of the picture's plane, each with a name.
function sides(points, name) {
  let stretch = 0;
  return points.map((point, i) => {
    const behind = point.towards < 0;
    if (i > 0 && behind !== points[i - 1].towards < 0) stretch += 1;
    return { ...point, behind, piece: `${name} ${stretch}`, step: i };
  });
}

function sphereLayers(points) {
  const project = seenFrom(middleOf(points) + 0.35, 0.45);
  const lines = net().flatMap((line, i) => sides(line.map(project), i)).filter(({ behind }) => !behind);
  const outline = circle((phi) => ({ x: Math.cos(phi), y: Math.sin(phi) })).map((point, step) => ({ ...point, step }));
  const path = sides(points.map(project), "path");
  const thin = { type: "line", strokeWidth: 0.6, color: ofPage("--quiet"), opacity: 0.5, tooltip: false };
  const order = { field: "step" };
  const drawn = (behind, mark) => ({ data: { values: path.filter((point) => point.behind === behind) },
    mark: { type: "line", color: colours[0], ...mark }, encoding: { order, detail: { field: "piece" } } });
  return { path: [...path, ...outline], layer: [
    { data: { values: lines }, mark: thin, encoding: { order, detail: { field: "piece" } } },
    { data: { values: outline }, mark: { ...thin, strokeWidth: 1, opacity: 1 }, encoding: { order } },
    drawn(true, { strokeWidth: 1, strokeDash: [3, 3], opacity: 0.7 }), drawn(false, { strokeWidth: 1.8 }),
    { data: { values: path.slice(0, 1) }, mark: { type: "point", filled: true, size: 60, color: colours[1] } },
  ] };
}

// The three axes through the least corner, as seen.
function spaceLayers(points, names) {
  const axes = ["x", "y", "z"];
  const ends = axes.map((axis) => [Math.min, Math.max].map((end) => end(...points.map((point) => point[axis]))));
  const longest = Math.max(...ends.map(([low, high]) => high - low)) || 1;
  const inBox = (point) => Object.fromEntries(axes.map((axis, i) => [axis, (point[axis] - ends[i][0]) / longest]));
  const project = seenFrom(-0.95, 0.4);
  const path = points.map((point) => project({ ...inBox(point), t: point.t }));
  const corner = { x: 0, y: 0, z: 0 };
  const arrows = axes.flatMap((axis, i) => [corner, { ...corner, [axis]: Math.max(0.3, (ends[i][1] - ends[i][0]) / longest) }]
    .map((end, step) => ({ ...project(end), step, axis: names[i], name: step ? names[i] : "" })));
  const quiet = ofPage("--quiet");
  return { path: [...path, ...arrows], layer: [
    { data: { values: arrows }, mark: { type: "line", strokeWidth: 0.8, color: quiet, tooltip: false }, encoding: { order: { field: "step" }, detail: { field: "axis" } } },
    { data: { values: arrows }, mark: { type: "text", dx: 8, dy: -4, color: quiet, fontSize: 11 }, encoding: { text: { field: "name" } } },
    { data: { values: path }, mark: { type: "line", strokeWidth: 1.6, color: colours[0] }, encoding: { order: { field: "t" } } },
    { data: { values: path.slice(0, 1) }, mark: { type: "point", filled: true, size: 60, color: colours[1] } },
  ] };
}

const isOnSphere = (points) => points.every(({ x, y, z }) => Math.abs(Math.hypot(x, y, z) - 1) < 1e-3);

function motionOf(section) {
  const { motion, t } = section.solution;
  if (!motion) return null;
  const { columns, values = columns.map((name) => section.solution.values[section.solution.columns.indexOf(name)]) } = motion;
  const points = t.map((time, i) => ({ t: time, x: values[0][i], y: values[1][i], ...(values[2] && { z: values[2][i] }) }));
  const inSpace = Boolean(values[2]);
  const sphere = inSpace && isOnSphere(points);
  const made = sphere ? sphereLayers(points) : inSpace ? spaceLayers(points, columns) : null;
  const axes = squareAxes(made ? made.path : points, made ? {} : { x: columns[0], y: columns[1] });
  const layers = made ? { encoding: axes, layer: made.layer } : curve(points, axes.x, axes.y);
  return {
    id: "motion", title: sphere ? "The motion on its sphere; dashed: behind it; the dot: t = 0" : `The motion, ${columns.join(", ")}; the dot: t = 0`,
    points, columns: ["t", "x", "y", ...(inSpace ? ["z"] : [])],
    spec: chart(`${section.title}: the path of the motion in ${columns.join(", ")}`, points, { ...layers, width: 300 }),
  };
}
