// Figures for papers: drawn without a browser, by the charts of the page.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { PAGE, RESULTS } from "./browser.js";
import { drawn, finished, runsOf } from "./records.js";

const { PROGRAM } = process.env;
const ofPendulum = finished(runsOf(RESULTS)).filter(({ scene }) => scene === "pendulum");
const figure = (name) => join(dirname(PAGE), name);
const plot = (kind, out) => ["plot", "pendulum", "--results", RESULTS, "--kind", kind, "--out", out];
const draw = (out, scene, kind, ...more) => {
  execFileSync(PROGRAM, ["plot", scene, "--kind", kind, ...more, "--out", figure(out)]);
  return readFileSync(figure(out));
};
const specOf = (...words) => JSON.parse(draw("spec.vl.json", ...words));

test("a figure has a mark for each record", () => {
  for (const [kind, chart] of [["work-precision", "error-against-time"], ["memory", "error-against-memory"], ["rate", "error-against-step"], ["accuracy", "delivered-against-asked"], ["energy", "energy-against-step"]]) {
    const out = figure(`${kind}.svg`);
    assert.equal(execFileSync(PROGRAM, plot(kind, out), { encoding: "utf8" }), `${out}\n`);
    const svg = readFileSync(out, "utf8");
    const marks = [...svg.matchAll(/class="mark-symbol role-mark[^"]*".*?<\/g>/gs)].map(([group]) => group.match(/<path/g)?.length ?? 0);
    assert.equal(marks.reduce((a, b) => a + b, 0), drawn[chart](ofPendulum, "error_maximum_mixed").length, kind);
    assert.match(svg, /font-family="Nimbus Roman/);
    assert.ok(Number(/width="([\d.]+)"/.exec(svg)[1]) <= 326, `${kind} is wider than a column`);  // 3.4 inches of 96 pixels
  }
});

test("a figure's specification is Vega-Lite with its numbers", () => {
  const spec = specOf("pendulum", "solution");
  assert.match(spec.$schema, /vega-lite\/v6/);
  assert.deepEqual(spec.data.values[0], { t: 0, column: "phi", value: 1 });
});

test("a figure as PDF has one page of a column's width and its letters in it", () => {
  const pdf = draw("solution.pdf", "pendulum", "solution").toString("latin1");
  assert.match(pdf, /^%PDF-/);
  const [width] = /\/MediaBox \[ 0 0 ([\d.]+) /.exec(pdf).slice(1).map(Number);
  assert.ok(width > 120 && width < 260, `${width} points wide`);
  assert.match(pdf, /\/FontFile/);
});

test("energy, multipliers and any columns are drawn over time", () => {
  const [first] = specOf("pendulum", "solution", "--columns", "energy").data.values;
  assert.equal(first.column, "energy");
  assert.ok(Math.abs(first.value - (0.3 ** 2 / 2 + 1 - Math.cos(1))) < 1e-4);
  // The multiplier of z' = y x' is x' y' / (1 + y^2).
  const [start] = specOf("nonholonomic_particle", "solution", "--columns", "lambda").data.values;
  assert.ok(Math.abs(start.value - 1 / 1.25) < 1e-4);
});

test("a range of a parameter is a family of curves", () => {
  const { data, vconcat } = specOf("relaxation", "solution", "--set", "lambda=-3:-1:1");
  assert.deepEqual([...new Set(data.values.map(({ parameter }) => parameter))], ["-3", "-2", "-1"]);
  assert.equal(vconcat.length, 1);
  assert.match(draw("family.svg", "relaxation", "solution", "--set", "lambda=-3:-1:1").toString(), /<svg/);
});

test("a motion is drawn where it is: in the plane, on its sphere", () => {
  const disc = specOf("rolling_disc", "motion").data.values;
  assert.ok(disc.every(({ x, y }) => Math.abs(x ** 2 + (y - 1) ** 2 - 1) < 1e-3));  // a circle of radius R psi'(0) / phi'(0)
  const course = specOf("loxodrome", "motion").data.values;
  assert.ok(course.every(({ x, y, z }) => Math.abs(x ** 2 + y ** 2 + z ** 2 - 1) < 1e-3));
});

test("regions of stability are those of the scene's order", () => {
  const { data } = specOf("relaxation:gamma=1", "stability", "--scheme", "adams_pc", "--scheme", "grunwald_letnikov");
  assert.deepEqual([...new Set(data.values.map(({ line }) => line))], ["adams_pc", "grunwald_letnikov"]);
  // Backward Euler: |1 - z| = 1. Heun's method: |1 + z + z^2/2| = 1.
  for (const { line, re, im } of data.values) {
    const square = line === "adams_pc" ? Math.hypot(1 + re + (re ** 2 - im ** 2) / 2, im + re * im) : Math.hypot(1 - re, im);
    assert.ok(Math.abs(square - 1) < 1e-3, `${line} ${re} ${im}`);
  }
});

test("what cannot be drawn is refused in a line", () => {
  for (const [words, complaint] of [[plot("pie", "f.svg"), /--kind = pie: must be one of/], [plot("rate", "f.gif"), /--out = f.gif: must end in/],
    [plot("rate", "/nonexistent/f.svg"), /cannot be drawn by node/],
    [["plot", "pendulum", "--kind", "rate", "--out", "f.svg"], /--results: --kind rate draws runs/],
    [["plot", "pendulum", "--kind", "stability", "--out", "f.svg"], /has several orders/],
    [["plot", "pendulum", "--kind", "solution", "--columns", "psi", "--out", "f.svg"], /--columns: psi is none of phi,/]]) {
    const { status, stderr } = spawnSync(PROGRAM, words, { encoding: "utf8" });
    assert.equal(status, 2);
    assert.match(stderr, complaint);
    assert.equal(stderr.trim().split("\n").length, 1);
  }
});
