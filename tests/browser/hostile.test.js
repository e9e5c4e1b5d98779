// SPDX-License-Identifier: MIT
// Results files that another program wrote, or nobody in good faith: names of JavaScript's own members, formulas without end, values that
// no axis has room for. And a part of the page that cannot be drawn leaves the others as they are.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { PAGE, RESULTS, drawAll, settled, withPage, withReadPage } from "./browser.js";
import { sectionOf } from "./charts.js";

const { PROGRAM } = process.env;
const folder = (name) => join(dirname(PAGE), name);
const lines = readFileSync(RESULTS, "utf8").trim().split("\n").map((line) => JSON.parse(line));

// The results of the pendulum with other schemes' names and another description, and their page.
function written(name, { schemes = {}, describe = () => {} }) {
  const file = folder(`${name}.jsonl`);
  const kept = lines.filter(({ session, scene }) => session || [scene, scene.scene].includes("pendulum")).map((line) => structuredClone(line));
  for (const line of kept) {
    if (Object.hasOwn(schemes, line.scheme)) line.scheme = schemes[line.scheme];
    if (line.scene?.scene) describe(line.scene);
  }
  writeFileSync(file, kept.map((line) => `${JSON.stringify(line)}\n`).join(""));
  execFileSync(PROGRAM, ["report", file, "--out", folder(name)]);
  return { file, page: join(folder(name), "index.html") };
}

// A figure as text, in which no number and no name is missing.
function plotted(...words) {
  const out = folder("hostile.svg");
  execFileSync(PROGRAM, ["plot", ...words, "--out", out]);
  const svg = readFileSync(out, "utf8");
  assert.doesNotMatch(svg, /undefined|NaN|native code/);
  return svg;
}

const chartsDrawn = (page, scene) => sectionOf(page, scene).locator("figure[data-chart] .chart svg").count();
const members = { l1: "constructor", adams_pc: "__proto__", bdf4: "toString", product_trapezoidal: "_" };
const columns = ["constructor", "__proto__", "toString", "a\u2028\"b"];
const describe = (scene) => Object.assign(scene.solution, { columns: columns.slice(0, scene.solution.columns.length) });

test("names of JavaScript's members are names like others", async () => {
  let expected = 0;
  await withReadPage("#scene-pendulum", async (page) => {
    await settled(page);
    expected = await chartsDrawn(page, "pendulum");
  });
  const { page: file, file: results } = written("members", { schemes: members, describe });
  await withPage({ page: file }, async (page) => {
    await drawAll(page);
    assert.equal(await chartsDrawn(page, "pendulum"), expected);
    const text = await page.locator("main").textContent();
    assert.doesNotMatch(text, /undefined|native code|\[object/);
    for (const name of Object.values(members)) assert.ok(text.includes(name), name);
  });
  const svg = plotted("pendulum", "--results", results, "--kind", "work-precision");
  for (const name of Object.values(members)) assert.ok(svg.includes(name), name);
});

test("an unknown may have the name of one of JavaScript's members", () => {
  const scene = folder("members.toml");
  const unknown = (name) => `[unknown.${name}]\norder = 0.5\nrhs = "-${name}"\ninitial = [1]\n`;
  writeFileSync(scene, `end = 1\n${unknown("constructor")}${unknown("toString")}`);
  const svg = plotted(scene, "--kind", "solution");
  for (const name of ["constructor", "toString"]) assert.ok(svg.includes(name), name);
});

test("a formula is shown whatever it is", () =>
  withReadPage("", async (page) => {
    const shown = (left) => page.evaluate((text) => {
      const made = equation({ left: text, right: "0" });
      document.querySelector("main").prepend(made);
      made.remove();
      return made.querySelector("mrow").textContent.replace(/=0$/, "");
    }, left);
    for (const [left, text] of [["D(x)", "D(x)"], ["J_right(x)", "J_right(x)"], ["sum(x)", "sum(x)"], ["f(a, b)", "f(a,b)"],
      ["constructor(x) + valueOf", "constructor(x)+valueOf"], ["D(x, constructor)", "Dconstructorx"]]) assert.equal(await shown(left), text);
    for (const long of ["(".repeat(20000), `${"-".repeat(1900)}x`, `${"(".repeat(900)}x${")".repeat(900)}`, Array(50000).fill("x").join("+")]) assert.equal(await shown(long), long);
  }));

test("values that no axis has room for are left out", async () => {
  const { page: file } = written("huge", { describe: ({ solution }) => {
    solution.values = solution.values.map((column) => column.map((value, i) => (i % 2 ? value : (i % 4 ? 1e308 : -1e308))));
  } });
  await withPage({ page: file }, async (page) => {
    await drawAll(page);
    assert.doesNotMatch(await sectionOf(page, "pendulum").textContent(), /NaN|Infinity/);
  });
});

test("a browser that cannot unpack the page says so in one sentence", () =>
  withPage({ prepare: () => delete globalThis.DecompressionStream }, async (page) => {
    assert.match(await page.locator("main").textContent(), /^This browser cannot unpack the page: it needs [^.]*(\.\d[^.]*)?\.$/);
  }));

// A fault in the script, the part of its section that is missing then, and one that is not.
for (const [fault, changed, missing] of [
  ["an equation", ["function equation({ left, right }) {", "function equation({ left, right }) { unheard.of();"], "The equation cannot be drawn."],
  ["the solution", ["function portraitOf(columns) {", "function portraitOf(columns) { unheard.of();"], "The solution cannot be drawn."],
  ["the charts", ["title: `Error against ${name}; band", "title: unheard.of + `"], "The charts cannot be drawn."],
  ["one chart", ["mark: { type: \"line\", strokeDash: [1, 3], strokeWidth: 1 }, encoding: { ...encoding", "mark: { type: \"line\", tooltip: { expr: \"unheard(1)\" } }, encoding: { ...encoding"], "This chart cannot be drawn."],
]) {
  test(`without ${fault} the rest of the page is drawn`, () =>
    assert.rejects(withPage({ changed }, async (page) => {
      await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
      const section = sectionOf(page, "pendulum");
      await section.locator(".missing").first().waitFor();
      assert.deepEqual(await section.locator(".missing").allTextContents(), [missing]);
      assert.ok(await section.locator("table").count() > 0);
      for (const scene of ["relaxation", "loxodrome"]) assert.ok(await sectionOf(page, scene).locator("table, figure").count() > 0, scene);
    }), /unheard/));
}
