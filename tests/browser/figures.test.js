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

test("a figure has a mark for each record", () => {
  for (const [kind, chart] of [["work-precision", "error-against-time"], ["rate", "error-against-step"], ["accuracy", "delivered-against-asked"], ["energy", "energy-against-step"]]) {
    const out = figure(`${kind}.svg`);
    assert.equal(execFileSync(PROGRAM, plot(kind, out), { encoding: "utf8" }), `${out}\n`);
    const svg = readFileSync(out, "utf8");
    const marks = [...svg.matchAll(/class="mark-symbol role-mark[^"]*".*?<\/g>/gs)].map(([group]) => group.match(/<path/g)?.length ?? 0);
    assert.equal(marks.reduce((a, b) => a + b, 0), drawn[chart](ofPendulum, "error_maximum_mixed").length, kind);
    assert.match(svg, /font-family="Nimbus Roman/);
    assert.ok(Number(/width="([\d.]+)"/.exec(svg)[1]) <= 260, "wider than a column");
  }
});

test("a figure's specification is Vega-Lite with its numbers", () => {
  const out = figure("solution.vl.json");
  execFileSync(PROGRAM, plot("solution", out));
  const spec = JSON.parse(readFileSync(out, "utf8"));
  assert.match(spec.$schema, /vega-lite\/v6/);
  assert.deepEqual(spec.data.values[0], { t: 0, column: "phi", value: 1 });
});

test("what cannot be drawn is refused in a line", () => {
  for (const [words, complaint] of [[plot("pie", "f.svg"), /--kind = pie: must be one of/], [plot("rate", "f.gif"), /--out = f.gif: must end in/],
    [plot("rate", "/nonexistent/f.svg"), /cannot be drawn by node/]]) {
    const { status, stderr } = spawnSync(PROGRAM, words, { encoding: "utf8" });
    assert.equal(status, 2);
    assert.match(stderr, complaint);
    assert.equal(stderr.trim().split("\n").length, 1);
  }
});
