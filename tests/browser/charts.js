// SPDX-License-Identifier: MIT
// What must hold of charts, checked on the page.
import assert from "node:assert/strict";
import { drawn, finished, scenesOf } from "./records.js";

// The marks of a chart as the browser has them: what each stands for, and whether it is inside its chart.
const marksOf = (figure) =>
  figure.evaluate((node) => {
    const box = node.querySelector("svg").getBoundingClientRect();
    const marks = [...node.querySelectorAll(".mark-symbol.role-mark path")];
    return {
      lines: new Set([...node.querySelectorAll(".mark-line.role-mark path")].map((path) => path.__data__.datum.line).filter(Boolean)).size,
      points: marks.map((mark) => {
        const { left, right, top, bottom } = mark.getBoundingClientRect();
        const { line, steps, error, energy_residual } = mark.__data__.datum;
        return { line, steps, error, energy_residual, inside: right > left && left >= box.left && right <= box.right && top >= box.top && bottom <= box.bottom };
      }),
    };
  });

// Five digits are all that a chart is given.
const close = (a, b) => Math.abs(a - b) <= 1e-4 * Math.abs(b);

export async function checkChart(figure, expected, valueOf, name) {
  const { points, lines } = await marksOf(figure);
  assert.equal(points.length, expected.length, `${name}: points`);
  assert.equal(lines, new Set(expected.map(({ scheme }) => scheme)).size, `${name}: lines`);
  for (const run of expected) {
    const found = points.find((point) => point.line === run.scheme && point.steps === run.steps && close(valueOf(point), valueOf(run)));
    assert.ok(found, `${name}: no point of ${run.scheme}, N = ${run.steps}`);
    assert.ok(found.inside, `${name}: ${run.scheme}, N = ${run.steps} cannot be seen`);
  }
}

export const sectionOf = (page, scene) => page.locator(`[id="scene-${scene}"]`);

// Every chart of these scenes has the marks of its records, and no chart is missing.
export async function checkCharts(page, runs, error, scenes = scenesOf(runs)) {
  for (const scene of scenes) {
    const ofScene = finished(runs).filter((run) => run.scene === scene);
    for (const [chart, choose] of Object.entries(drawn)) {
      const expected = choose(ofScene, error);
      const figure = sectionOf(page, scene).locator(`figure[data-chart="${chart}"]`);
      assert.equal(await figure.count(), expected.length > 0 ? 1 : 0, `${scene}: ${chart}`);
      if (expected.length === 0) continue;
      const valueOf = chart === "energy-against-step" ? (of) => of.energy_residual : (of) => of.error ?? of[error];
      await checkChart(figure, expected, valueOf, `${scene}: ${chart}`);
    }
  }
}
