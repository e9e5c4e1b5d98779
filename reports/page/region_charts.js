// SPDX-License-Identifier: MIT
// Where the regions of linear stability end, in the upper half plane of z = λ h^γ, beside the exact sector.

const shownPlane = { left: -5, right: 5, top: 5 };

// A curve of several schemes is drawn as the first of them that is wanted.
function pointsOfRegions({ orders, curves, same }, wants) {
  const nameOf = (scheme) => [scheme, ...Object.keys(same).filter((other) => same[other] === scheme)].find((name) => wants(name));
  return Object.entries(curves).map(([scheme, ofOrders]) => [nameOf(scheme), ofOrders]).filter(([line]) => line).flatMap(([line, ofOrders]) => ofOrders.flatMap((pieces, i) =>
    (pieces ?? []).flatMap((flat, piece) => Array.from({ length: flat.length / 2 }, (_, step) =>
      ({ line, order: orders[i], piece: `${line} ${piece}`, step, re: flat[2 * step], im: flat[2 * step + 1] })))));
}

// The ray at which the solution's decay ends, up to the window's edge.
const rays = (orders) => orders.flatMap((order) => {
  const angle = (order * Math.PI) / 2, far = 2 * shownPlane.right;
  return [{ order, re: 0, im: 0 }, { order, re: far * Math.cos(angle), im: far * Math.sin(angle) }];
});

function stabilityRegions(section, lines, wants) {
  const { regions } = section;
  const points = pointsOfRegions(regions, wants);
  const all = [...lines, ...[...Object.keys(regions.curves), ...Object.keys(regions.same)].filter((scheme) => !lines.includes(scheme))];
  const channels = lineChannels(all, points);
  const several = regions.orders.length > 1;
  const axis = (field, title, domain) => ({ field, title, type: "quantitative", scale: { domain, nice: false } });
  const encoding = { x: axis("re", "Re z", [shownPlane.left, shownPlane.right]), y: axis("im", "Im z", [0, shownPlane.top]) };
  const now = several ? [{ filter: "abs(datum.order - order) < 0.01" }] : [];
  const steps = several ? { name: "order", value: 0.5,
    bind: { name: "order γ of the equation ", input: "range", min: regions.orders[0], max: regions.orders.at(-1), step: 0.2 } } : null;
  const width = Math.min(760, (globalThis.innerWidth ?? 800) - 110);
  const lineOf = { order: { field: "step" }, detail: { field: "piece" } };
  const quiet = ofPage("--quiet");
  return {
    id: "stability-regions", points, columns: ["line", "order", "re", "im"],
    title: `Where stability ends${several ? "" : ` at γ = ${regions.orders[0]}`}: solid a scheme's region, dashed the equation's`,
    spec: chart("Boundaries of the regions of linear stability in the upper half plane, a line for each scheme, and the ray of the exact sector", points, {
      width, height: (width * shownPlane.top) / (shownPlane.right - shownPlane.left), ...(steps && { params: [steps] }),
      layer: [
        { data: { values: [{}] }, mark: { type: "rule", color: quiet, opacity: 0.5, tooltip: false }, encoding: { x: { datum: 0 } } },
        { data: { values: rays(regions.orders) }, transform: now, mark: { type: "line", strokeDash: [5, 4], strokeWidth: 1.6, color: ofPage("--text"), clip: true, tooltip: false }, encoding },
        { transform: now, mark: { type: "line", strokeWidth: 1.5, clip: true, tooltip: { expr: "datum.line" } }, encoding: { ...encoding, ...lineOf, ...channels.colour } },
        { transform: [...now, { filter: "datum.step % 8 == 3" }], params: [picked], mark: { type: "point", filled: true, size: 40, clip: true, tooltip: { expr: "datum.line" } },
          encoding: { ...encoding, ...channels.colour, ...channels.shape } },
      ],
    }),
  };
}
