// SPDX-License-Identifier: MIT
// What of a figure is its author's: axes, the places of names; and what its panels share.

// Calls change with each encoding of a specification, { x, y, color, ... }, and returns the specification with what it returns.
const encoded = (of, change) => (Array.isArray(of) ? of.map((one) => encoded(one, change))
  : of === null || typeof of !== "object" ? of
  : Object.fromEntries(Object.entries(of).map(([key, value]) => [key, key === "encoding" ? change(value) : key === "values" ? value : encoded(value, change)])));

// The values of a field that are drawn anywhere.
const valuesOf = (of, field) => (Array.isArray(of) ? of.flatMap((one) => valuesOf(one, field))
  : of === null || typeof of !== "object" ? []
  : [...(typeof of[field] === "number" ? [of[field]] : []), ...Object.values(of).flatMap((one) => valuesOf(one, field))]);

// A refusal of what is asked for, in words of ours.
class Refusal extends Error {}

// Ticks with units of their own, as 2 µs, would contradict the unit of a title of one's own.
const unitOf = ({ axis }) => ({ [labels.time]: "s", [labels.bytes]: "bytes" })[axis?.labelExpr];
const withoutUnits = (axis) => (unitOf(axis) ? { ...axis, axis: { ...axis.axis, labelExpr: labels.number } } : axis);

// The axes with the titles and the scales that are wanted; of panels one above the other the first has the title of the vertical one.
function withAxes(spec) {
  const titled = { x: false, y: false };
  let hasLogarithmicTime = false;
  const axisOf = (channel, axis, isFirst) => {
    const { [channel]: { title, type } } = style.axes, isNamed = title !== null && axis.title !== undefined && axis.title !== null && (channel === "x" || isFirst);
    titled[channel] ||= isNamed;
    const named = isNamed ? withoutUnits({ ...axis, title }) : axis;
    if (type === null || axis.field === undefined || type === (axis.scale?.type ?? "linear")) return named;
    if (type === "linear") return { ...linear(axis.field, isNamed || !unitOf(axis) ? named.title : `${axis.title} in ${unitOf(axis)}`), scale: { zero: false, nice: false, padding: axisPadding } };
    hasLogarithmicTime ||= axis.field === "t";
    const values = valuesOf(spec, axis.field).filter((value) => axis.field !== "t" || value > 0);
    if (!values.every((value) => value > 0)) throw new Refusal(`--${channel}-axis = log: ${axis.title || axis.field} has values that are not above 0`);
    return logAxis(values.map((value) => ({ [axis.field]: value })), axis.field, named.title, labels.number);
  };
  const changed = (of, isFirst) => encoded(of, (encoding) => ({ ...encoding,
    ...Object.fromEntries(["x", "y"].filter((name) => encoding[name]?.type === "quantitative").map((name) => [name, axisOf(name, encoding[name], isFirst)])) }));
  const { vconcat, ...rest } = spec;
  const made = { ...changed(rest, true), ...(vconcat && { vconcat: vconcat.map((panel, i) => changed(panel, i === 0)) }) };
  for (const name of ["x", "y"]) if (style.axes[name].title !== null && !titled[name]) throw new Refusal(`--${name}-label: this figure has no such axis`);
  return hasLogarithmicTime ? withoutStart(made) : made;
}

// On a logarithmic axis of the time there is no t = 0.
const withoutStart = (of) => (Array.isArray(of) ? of.filter((one) => !(one?.t <= 0)).map(withoutStart)
  : of === null || typeof of !== "object" ? of
  : Object.fromEntries(Object.entries(of).map(([key, value]) => [key, withoutStart(value)])));

// A legend at a side, names at the lines, or neither. By default names where they fit.
function withNames(made, lines) {
  const { spec } = style.legend === "labels" ? withLineLabels(made, lines, true) : style.legend === null ? withLineLabels(made, lines) : made;
  const isLabelled = spec.layer?.some(({ name }) => name === "labels") && (style.legend ?? "labels") === "labels";
  if (style.legend === "labels" && !isLabelled) throw new Refusal("--legend = labels: needs the lines of at least two schemes");
  const layer = spec.layer?.filter(({ name }) => isLabelled || name !== "labels");
  const legendOf = (legend) => (!legend ? legend : isLabelled || style.legend === "none" ? null : style.legend ? { ...legend, orient: style.legend, ...(style.legend === "right" && { columns: 1 }) } : legend);
  return encoded({ ...spec, ...(layer && { layer }) }, (encoding) => Object.fromEntries(Object.entries(encoding).map(([channel, of]) => [channel, of?.legend === undefined ? of : { ...of, legend: legendOf(of.legend) }])));
}

// Panels side by side. A colour, a shape and dashes stand for the same line in all of them, and their legend is one.
function sideBySide(panelSpecs) {
  const channels = ["color", "shape", "strokeDash"], marks = new Map(channels.map((name) => [name, new Map()]));
  const ofLines = (encoding) => channels.filter((name) => encoding[name]?.field === "line" && encoding[name].scale?.range);
  const collect = (encoding) => {
    for (const name of ofLines(encoding)) encoding[name].scale.domain.forEach((line, i) => marks.get(name).has(line) || marks.get(name).set(line, encoding[name].scale.range[i]));
    return encoding;
  };
  const share = (encoding) => ({ ...encoding, ...Object.fromEntries(ofLines(encoding).map((name) => {
    const known = marks.get(name), { legend } = encoding[name], domain = [...known.keys()];
    return [name, { ...encoding[name], scale: { domain, range: [...known.values()] }, legend: legend && { ...legend, ...(ownNames.size > 0 && { labelExpr: namesInLegend(domain) }) } }];
  })) });
  encoded(panelSpecs, collect);
  // Vega takes layers of one name for one.
  const named = panelSpecs.map((spec, i) => ({ ...spec, ...(spec.layer && { layer: spec.layer.map((layer) => ({ ...layer, ...(layer.name && { name: `${layer.name}-${i}` }) })) }) }));
  const how = marks.get("color").size > 0 ? "shared" : "independent";
  return { resolve: { scale: Object.fromEntries(channels.map((name) => [name, how])) }, hconcat: encoded(named, share) };
}
