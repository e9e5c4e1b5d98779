// SPDX-License-Identifier: MIT
// Figures for papers: drawn without a browser, by the charts of the page.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { PAGE, RESULTS, withReadPage } from "./browser.js";
import { drawn, finished, runsOf } from "./records.js";

const { PROGRAM } = process.env;
const ofPendulum = finished(runsOf(RESULTS)).filter(({ scene }) => scene === "pendulum");
const figure = (name) => join(dirname(PAGE), name);
const MEASURED = figure("measured.csv");
writeFileSync(MEASURED, "t,y,sd_y\n0.25,0.6,0.02\n0.5,0.53,0.02\n1,0.42,0.02\n");
const plot = (kind, out) => ["plot", "pendulum", "--results", RESULTS, "--kind", kind, "--out", out];
const fdebench = (words) => promisify(execFile)(PROGRAM, words);
const draw = async (out, scene, kind, ...more) => {
  await fdebench(["plot", scene, "--kind", kind, ...more, "--out", figure(out)]);
  return readFileSync(figure(out));
};
// Two tests may draw at a time.
let specs = 0;
const specOf = async (...words) => JSON.parse(await draw(`spec${++specs}.vl.json`, ...words));

// 3.4 inches of 96 pixels; letters of 8 points are 32/3 pixels high.
function checkPaper(svg, name) {
  assert.equal(Number(/width="([\d.]+)"/.exec(svg)[1]), 326.4, `${name}: width`);
  for (const [, size] of svg.matchAll(/font-size="([\d.]+)px"/g)) assert.ok(Math.abs(size - 32 / 3) < 1e-6, `${name}: letters of ${size} pixels`);
  // What is drawn fills the column: the frame ends within it, at most a few pixels before its edge.
  const frames = [...svg.matchAll(/class="background"[^>]* d="M[\d.-]+,[\d.-]+h([\d.]+)/g)].map(([, width]) => Number(width));
  assert.ok(Math.max(...frames) > 180 && Math.max(...frames) < 326.4, `${name}: a frame of ${frames}`);
}

test("a figure has a mark for each record", async () => {
  for (const [kind, chart] of [["work-precision", "error-against-time"], ["memory", "error-against-memory"], ["rate", "error-against-step"], ["accuracy", "delivered-against-requested"], ["energy", "energy-against-step"]]) {
    const out = figure(`${kind}.svg`);
    assert.equal((await fdebench(plot(kind, out))).stdout, `${out}\n`);
    const svg = readFileSync(out, "utf8");
    const marks = [...svg.matchAll(/class="mark-symbol role-mark[^"]*".*?<\/g>/gs)].map(([group]) => group.match(/<path/g)?.length ?? 0);
    assert.equal(marks.reduce((a, b) => a + b, 0), drawn[chart](ofPendulum, "error_maximum_mixed").length, kind);
    assert.match(svg, /font-family="Nimbus Roman/);
    checkPaper(svg, kind);
  }
});

test("every kind of figure is as wide as a column, its letters have 8 points", async () => {
  for (const [scene, kind, ...more] of [["pendulum", "solution"], ["pendulum", "phase"], ["loxodrome", "motion"], ["rolling_disc", "motion"], ["relaxation", "stability"],
    ["relaxation", "solution", "--set", "lambda=-3:-1:1"], ["relaxation", "residuals", "--data", MEASURED], ["pendulum", "work-precision", "--results", RESULTS, "--scheme", "l1"]]) {
    checkPaper((await draw("paper.svg", scene, kind, ...more)).toString(), `${scene} ${kind}`);
  }
});

// The colour and the shape of each scheme in a figure.
function marksIn(spec) {
  const found = {};
  const look = (of) => {
    if (of === null || typeof of !== "object") return;
    for (const [channel, { field, scale }] of Object.entries(of).filter(([key, value]) => ["color", "shape"].includes(key) && value?.field === "line" && value.scale)) {
      assert.equal(field, "line");
      scale.domain.forEach((line, i) => { (found[line] ??= {})[channel] = scale.range[i]; });
    }
    Object.values(of).forEach(look);
  };
  look(spec);
  return found;
}

test("a scheme has its colour and its mark in every figure and on the page", async () => {
  const drawings = [["pendulum", "work-precision", "--results", RESULTS], ["relaxation", "rate", "--results", RESULTS], ["pendulum", "rate", "--results", RESULTS, "--scheme", "bdf4", "--scheme", "l1"],
    ["relaxation:gamma=0.8", "work-precision", "--results", RESULTS], ["relaxation", "stability", "--scheme", "bdf4", "--scheme", "adams_pc", "--scheme", "l1"]];
  const figures = await Promise.all(drawings.map((words) => specOf(...words)));
  await withReadPage("", async (page) => {
    for (const marks of figures.map(marksIn)) {
      assert.ok(Object.keys(marks).length >= 2);
      for (const [line, { color, shape }] of Object.entries(marks))
        assert.deepEqual({ color, shape }, await page.evaluate((of) => ({ color: colourOf(data.lines, of), shape: shapeOf(data.lines, of) }), line), line);
    }
  });
});

const encodingsIn = (of) => (of === null || typeof of !== "object" ? [] : [...(of.encoding ? [of.encoding] : []), ...Object.values(of).flatMap(encodingsIn)]);

test("axes, names and the place of the legend are the author's", async () => {
  const words = ["pendulum", "work-precision", "--results", RESULTS, "--scheme", "l1", "--scheme", "bdf4"];
  const labels = (spec) => spec.layer.filter(({ mark }) => mark.type === "text").flatMap(({ data }) => data.values.map(({ line, name }) => [line, name]));
  const own = await specOf(...words, "--x-label", "time (s)", "--y-label", "error", "--y-axis", "linear", "--name", "l1=L1 = Oldham & Spanier");
  assert.deepEqual(labels(own).sort(), [["bdf4", "bdf4"], ["l1", "L1 = Oldham & Spanier"]]);
  for (const { x, y } of encodingsIn(own)) assert.deepEqual([x?.title ?? "time (s)", y?.title ?? "error", x?.scale?.type, y?.scale?.type], ["time (s)", "error", "log", undefined]);
  const times = encodingsIn(await specOf(...words, "--x-axis", "linear")).map(({ x }) => x?.title).filter(Boolean);
  assert.deepEqual([...new Set(times)], ["run time in s"]);
  for (const place of ["bottom", "right"]) {
    const placed = await specOf(...words, "--legend", place);
    assert.deepEqual(labels(placed), []);
    assert.ok(encodingsIn(placed).some(({ color }) => color?.legend?.orient === place));
  }
  const bare = await specOf(...words, "--legend", "none");
  assert.deepEqual([labels(bare), encodingsIn(bare).filter(({ color, shape }) => color?.legend || shape?.legend)], [[], []]);
  // t begins with 0, which no logarithm has.
  assert.equal((await specOf("relaxation", "solution", "--y-axis", "log")).encoding.y.scale.type, "log");
  // On a logarithmic axis of the time there is no t = 0; phi passes through 0.
  const { data, encoding } = await specOf("relaxation", "solution", "--x-axis", "log");
  assert.equal(encoding.x.scale.type, "log");
  assert.ok(data.values.every(({ t }) => t > 0));
  await assert.rejects(specOf("pendulum", "solution", "--columns", "phi", "--y-axis", "log"), /^Error: .*\n?fdebench: --y-axis = log: φ has values that are not above 0/s);
  await assert.rejects(specOf("loxodrome", "motion", "--x-label", "x"), /fdebench: --x-label: this figure has no such axis/);
  // A unit in a title is that of the ticks.
  assert.ok(encodingsIn(own).every(({ x }) => !x?.axis?.labelExpr?.includes("'s'")));
});

test("measurements and residuals are over one axis of time, and the first panel has the title", async () => {
  const { vconcat, resolve } = await specOf("relaxation", "residuals", "--data", MEASURED, "--y-label", "strain (%)", "--name", "residual=left");
  assert.equal(resolve.scale.x, "shared");
  const titles = vconcat.map((panel) => [...new Set(encodingsIn(panel).map(({ y }) => y?.title).filter(Boolean))]);
  assert.deepEqual(titles, [["strain (%)"], ["left"]]);
});

test("several scenes are panels of one figure, in which a scheme has one mark", async () => {
  const two = ["pendulum", "relaxation:gamma=0.8"], of = ["--kind", "work-precision", "--results", RESULTS, "--name", `${two[1]}=(b)`];
  await fdebench(["plot", ...two, ...of, "--out", figure("two.svg")]);
  const svg = readFileSync(figure("two.svg"), "utf8");
  assert.equal(Number(/width="([\d.]+)"/.exec(svg)[1]), 672);
  await fdebench(["plot", ...two, ...of, "--out", figure("two.vl.json")]);
  const { hconcat } = JSON.parse(readFileSync(figure("two.vl.json"), "utf8"));
  assert.deepEqual(hconcat.map(({ title }) => title), ["pendulum", "(b)"]);
  const [first, second] = hconcat.map(marksIn), shared = Object.keys(first).filter((line) => second[line]);
  assert.ok(shared.length > 1);
  for (const line of shared) assert.deepEqual(first[line], second[line]);
  // Each panel has the points of its own scene.
  const names = hconcat.flatMap(({ layer }) => layer.map(({ name }) => name).filter(Boolean));
  assert.equal(new Set(names).size, names.length);
});

test("what does not fit is reduced, and said", async () => {
  const { stderr } = await fdebench([...plot("rate", figure("wide.svg")), "--legend", "bottom", "--name", `l1=${"long ".repeat(20)}`]);
  assert.match(stderr, /warning: what is drawn is wider than the figure, and its letters have \d\.\d points: give a larger --width or shorter names by --name/);
});

test("a figure's specification is Vega-Lite with its numbers", async () => {
  const spec = await specOf("pendulum", "solution");
  assert.match(spec.$schema, /vega-lite\/v6/);
  assert.deepEqual(spec.data.values[0], { t: 0, column: "phi", value: 1 });
});

test("a figure as PDF has one page of a column's width and its letters in it", async () => {
  const pdf = (await draw("solution.pdf", "pendulum", "solution")).toString("latin1");
  assert.match(pdf, /^%PDF-/);
  const [width] = /\/MediaBox \[ 0 0 ([\d.]+) /.exec(pdf).slice(1).map(Number);
  assert.ok(Math.abs(width - 3.4 * 72) < 0.1, `${width} points wide`);
  assert.match(pdf, /\/FontFile/);
});

test("energy, multipliers and any columns are drawn over time", async () => {
  const [first] = (await specOf("pendulum", "solution", "--columns", "energy")).data.values;
  assert.equal(first.column, "energy");
  assert.ok(Math.abs(first.value - (0.3 ** 2 / 2 + 1 - Math.cos(1))) < 1e-4);
  // The multiplier of z' = y x' is x' y' / (1 + y^2).
  const [start] = (await specOf("nonholonomic_particle", "solution", "--columns", "lambda")).data.values;
  assert.ok(Math.abs(start.value - 1 / 1.25) < 1e-4);
});

test("a range of a parameter is a family of curves", async () => {
  const { data, vconcat } = await specOf("relaxation", "solution", "--set", "lambda=-3:-1:1");
  assert.deepEqual([...new Set(data.values.map(({ parameter }) => parameter))], ["-3", "-2", "-1"]);
  assert.equal(vconcat.length, 1);
});

// D^beta phi tends to phi - phi(0) for beta to 0, and D^alpha phi to phi' - phi'(0) for alpha to 1: of a start at rest to phi'.
test("a curve that is not the limit of its neighbours is dashed, and a note says what they tend to", async () => {
  const dashed = ({ data }) => [...new Set(data.values.filter(({ apart }) => apart).map(({ parameter }) => parameter))];
  const overBeta = await specOf("pendulum:until=1", "solution", "--set", "beta=0:0.5:0.25");
  assert.deepEqual(dashed(overBeta), ["0"]);
  assert.deepEqual(overBeta.title.text, ["Dashed: β = 0, not the limit of its neighbours.", "As β → 0, Dᵝφ tends to φ − φ(0)."]);
  const overAlpha = await specOf("pendulum:until=1", "phase", "--columns", "phi,dphi", "--set", "alpha=1:2:0.5");
  assert.deepEqual(dashed(overAlpha), ["1"]);
  assert.deepEqual(overAlpha.title.text, ["Dashed: α = 1, not the limit of its neighbours.", "As α → 1, Dᵅφ tends to φ′ − φ′(0)."]);
  const fromRest = await specOf("pendulum:until=1,dphi0=0", "solution", "--set", "alpha=1:2:0.5");
  assert.deepEqual(dashed(fromRest), []);
  assert.equal(fromRest.title, undefined);
  checkPaper((await draw("apart.svg", "pendulum:until=1", "solution", "--set", "beta=0:0.5:0.25")).toString(), "a family with a note");
});

test("a motion is drawn where it is: in the plane, on its sphere", async () => {
  const disc = (await specOf("rolling_disc", "motion")).data.values;
  assert.ok(disc.every(({ x, y }) => Math.abs(x ** 2 + (y - 1) ** 2 - 1) < 1e-3));  // a circle of radius R psi'(0) / phi'(0)
  const course = (await specOf("loxodrome", "motion")).data.values;
  assert.ok(course.every(({ x, y, z }) => Math.abs(x ** 2 + y ** 2 + z ** 2 - 1) < 1e-3));
});

test("regions of stability are those of the scene's order", async () => {
  const { data } = await specOf("relaxation:gamma=1", "stability", "--scheme", "adams_pc", "--scheme", "grunwald_letnikov");
  assert.deepEqual([...new Set(data.values.map(({ line }) => line))], ["adams_pc", "grunwald_letnikov"]);
  // Backward Euler: |1 - z| = 1. Heun's method: |1 + z + z^2/2| = 1.
  for (const { line, re, im } of data.values) {
    const square = line === "adams_pc" ? Math.hypot(1 + re + (re ** 2 - im ** 2) / 2, im + re * im) : Math.hypot(1 - re, im);
    assert.ok(Math.abs(square - 1) < 1e-3, `${line} ${re} ${im}`);
  }
});

test("what cannot be drawn is refused in a line", async () => {
  for (const [words, complaint] of [[plot("pie", "f.svg"), /--kind = pie: must be work-precision, .* or stability/], [plot("rate", "f.gif"), /--out = f.gif: must end in/],
    [plot("rate", "/nonexistent/f.svg"), /cannot be drawn by node/],
    [["plot", "pendulum", "--kind", "rate", "--out", "f.svg"], /--results: --kind rate draws runs/],
    [["plot", "pendulum", "--kind", "stability", "--out", "f.svg"], /has several orders/],
    [["plot", "pendulum", "--kind", "solution", "--legend", "labels", "--out", "f.svg"], /--legend = labels: --kind solution draws no errors/],
    [["plot", "pendulum", "--kind", "solution", "--name", "psi=Psi", "--out", "f.svg"], /--name = psi=Psi: must be NAME=TEXT with a name of .*phi; /],
    [["plot", "pendulum", "--kind", "solution", "--width", "0.5", "--out", "f.svg"], /--width = 0.5: must be a number in \[1, 40\]/],
    [["plot", "pendulum", "--kind", "solution", "--y-axis", "cubic", "--out", "f.svg"], /--y-axis = cubic: must be log or linear/],
    [["plot", "pendulum", "--kind", "orders", "--results", RESULTS, "--width", "4", "--out", "f.tex"], /--width = 4: --kind orders draws no figure/],
    [["plot", "pendulum", "loxodrome", "--kind", "orders", "--results", RESULTS, "--out", "f.tex"], /--kind orders writes a table of one scene/],
    [["plot", "pendulum", "--kind", "solution", "--columns", "psi", "--out", "f.svg"], /--columns = psi: must be of phi,/]]) {
    const { code, stderr } = await fdebench(words).catch((refused) => refused);
    assert.equal(code, 2);
    assert.match(stderr, complaint);
    assert.equal(stderr.trim().split("\n").length, 1);
  }
});
