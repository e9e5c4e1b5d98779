// SPDX-License-Identifier: MIT
// The page's templates: how facts become sentences, numbers and cells.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { withReadPage } from "./browser.js";

// What the page says of facts, each [template or name of a statement, facts].
const saidOf = (page, all) => page.evaluate((cases) => cases.map(([template, facts]) => say(statements[template] ?? template, facts)), all);

async function checkSaid(cases) {
  await withReadPage("", async (page) => {
    const said = await saidOf(page, cases.map(([template, facts]) => [template, facts]));
    assert.deepEqual(said, cases.map(([, , text]) => text));
  });
}

test("a template is filled with facts, and what lacks one is left out", () => checkSaid([
  ["{a} of {b.c:error}", { a: 2, b: { c: 1.23e-7 } }, "2 of 1.2e-7"],
  ["{a} of {b.c:error}", { a: 2, b: {} }, ""],
  ["{a}[ and {b}[ or {c}]]", { a: "x", c: "z" }, "x"],
  ["{a}[ and {b}[ or {c}]]", { a: "x", b: "y" }, "x and y"],
  [["{b}", "{a} alone"], { a: 0 }, "0 alone"],
  ["{list.1}, {list:count/ to }", { list: [64, 12800] }, "12800, 64 to 12\u202f800"],
  ["{list:time/ to }", { list: [1.001e-3, 1.002e-3] }, "1.00 ms"],
  ["{names:few}; {names:scenes}", { names: ["a", "b", "c", "d"] }, "a, b, c and 1 more; 4 scenes"],
  ["[{?a}yes][{!a}no]", { a: false }, "no"],
  ["{n} run[{!n=1}s]", { n: 1 }, "1 run"],
  ["{n} run[{!n=1}s]", { n: 2 }, "2 runs"],
  ["{a}", { a: "{b} [c]" }, "{b} [c]"],
]));

test("numbers are rounded for readers", () => withReadPage("", async (page) => {
  const texts = await page.evaluate(() => Object.entries({
    error: [1.23e-7, 9.96e-8, 0, 370], time: [3.456e-3, 1.2345e-5, 78.91, 640, 5e-10], bytes: [123, 65536], count: [8192, 1234567, 1.2e9], rough: [34567, 42],
    ratio: [1.5, 34567], power: [1e-10], three: [7360.4, 2.4427e-4],
  }).map(([format, values]) => values.map(numberFormats[format])));
  assert.deepEqual(texts, [
    ["1.2e-7", "1.0e-7", "0", "3.7e2"], ["3.46 ms", "12.3 µs", "78.9 s", "640 s", "0.50 ns"], ["123 B", "65.5 kB"], ["8192", "1\u202f234\u202f567", "1.2e9"],
    ["35\u202f000", "42"], ["1.5", "35\u202f000"], ["1e-10"], ["7360", "0.000244"],
  ]);
}));

const run = { line: "l1", steps: 256, error: 5.5e-5, seconds: 256e-6, low: 255e-6, high: 258e-6 };
test("a run is said with its time, and why it is the cheapest", () => checkSaid([
  ["run", run, "N = 256, error 5.5e-5, 256 µs (255 µs ... 258 µs)"],
  ["run", { ...run, grid: "graded:2", requested: 1e-6, wall_clock: true, first_seconds: 1, session: 2 },
    "graded:2, accuracy 1.0e-6, N = 256, error 5.5e-5, 256 µs (255 µs ... 258 µs) of the wall clock, 1.00 s in the first run of a process, session 2"],
  ["run", { line: "l1", steps: 256, error: 5.5e-5 }, "N = 256, error 5.5e-5, not timed"],
  ["its_run", { best: run }, "best: l1, N = 256, error 5.5e-5, 256 µs (255 µs ... 258 µs)"],
  ["cheapest", { untimed: true, best: run }, "reached, not timed yet"],
  ["cheapest", { best: run }, "none measured reaches it"],
  ["cheapest", {}, "no run has this error"],
  ["why", { ...run, second: { line: "bdf2", ratio: 1.5, step_seconds: [1e-6, 3e-6] } }, "1.5 times as quick as bdf2: a step takes 1.00 µs where one of bdf2 takes 3.00 µs"],
  ["why", { ...run, second: { line: "bdf2", ratio: 120.4, steps: [64, 20000], rates: [2, 1.04], dearer: 2.5 } },
    "120 times as quick as bdf2: 64 steps are enough where bdf2 needs 20\u202f000, by its rate, 2.0 against 1.0, although a step takes 2.5 times as long"],
  ["why", { ...run, ties: ["bdf2", "bdf3"], second: { line: "bdf2", ratio: 1 } }, "within noise of bdf2, bdf3"],
  ["why", run, "no other line gets there"],
  ["why", { ...run, next_best: { line: "bdf2", error: 1e-3 } }, "no other line gets there; the next best, bdf2, has 1.0e-3"],
  ["why", { best: run, needed: { line: "l1", steps: 4123, low: 3987, high: 5012 } }, "l1 would need about N = 4100 (4000 ... 5000), by its errors so far"],
  ["why", { best: run, needed: { line: "l1", steps: 4123, low: 3987, high: 5012, seconds: 3 } }, "l1 would need about N = 4100 (4000 ... 5000) and 3.00 s, by its errors so far"],
  ["why", { best: run, is_rounding: true, needed: { line: "l1", steps: 4123, low: 3987, high: 5012 } }, "this error of l1 is rounding error"],
  ["why", { best: run, known_up_to: 1e-4 }, "the reference is known to 1.0e-4 only"],
  ["why", { best: run }, "no error so far falls with the steps"],
]));

test("the conclusion on a scene names the cheapest lines, the limit and what is left out", () => checkSaid([
  ["conclusion", {
    cheapest: [{ line: "l1", from: 1e-2, to: 1e-4, seconds: [1e-5, 2e-4] }, { line: "bdf4", to: 1e-6, seconds: [1e-3, 1e-3] }], leader: { line: "bdf4", accuracy: 1e-6 },
    limit: { accuracy: 1e-8, error: 2e-7, line: "bdf4", is_rounding: true }, ended: ["bdf6"], refused: 1,
  }, "Cheapest: l1 from 1e-2 to 1e-4 (10.0 µs to 200 µs), then bdf4 to 1e-6 (1.00 ms). Only bdf4 reaches 1e-6. " +
    "No run is within 1e-8: the best has 2.0e-7, by bdf4, which is rounding. Some runs of bdf6 end early. 1 scheme refuses it, with the reason under Refused and failed."],
  ["conclusion", { leader: { line: "l1", accuracy: 1e-2, second: { line: "bdf4", step_seconds: [1e-6, 2e-6] } }, refused: 2 },
    "To 1e-2 l1 leads: a step takes 1.00 µs where one of bdf4 takes 2.00 µs. 2 schemes refuse it, with the reason under Refused and failed."],
  ["conclusion", {}, ""],
]));

test("of a scheme it says where it wins or is nearest, and what speaks against it", () => checkSaid([
  ["wins", { won: 3, cells: 7, scenes: ["pendulum"], next: 1.26 }, "Cheapest in 3 of 7 cells: pendulum. The next takes 1.3 times as long, in the median."],
  ["wins", { won: 3, cells: 7, scenes: ["pendulum"], next: 1.01, as_quick: true }, "Cheapest in 3 of 7 cells: pendulum. The next is as quick, in the median."],
  ["wins", { won: 1, cells: 7, scenes: ["pendulum"] }, "Cheapest in 1 of 7 cells: pendulum."],
  ["wins", { is_part: true, nearest: { scene: "pendulum" } }, "Wins none of these cells."],
  ["wins", { nearest: { scene: "pendulum", accuracy: 1e-4, ratio: 1.5 } }, "Cheapest nowhere; nearest on pendulum to 1e-4, in 1.5 times the least time."],
  ["wins", {}, "Reaches none of these accuracies."],
  ["faults", { against: [{ fails: ["a"] }, { inaccurate: ["b"] }, { refuses: ["c"], reason: "takes no such order" }] },
    "fails on a; inaccurate on b; refuses c (takes no such order)."],
  ["faults", { trials: 1 }, "Survives its trial."],
  ["faults", { trials: 4 }, "Survives all 4 trials."],
  ["faults", {}, ""],
]));

const outcomes = [...readFileSync(new URL("../../benchmarks/measures/run_outcome.cpp", import.meta.url), "utf8").matchAll(/OutcomeText\{[\w:]+, "(\w+)"/g)].map(([, id]) => id);
test("every way in which a run ends has its words, and an unknown one is shown by its id", () => withReadPage("", async (page) => {
  assert.ok(outcomes.length > 10);
  const words = await page.evaluate(() => Object.keys(statements.outcome));
  assert.deepEqual(words.sort(), outcomes.filter((id) => id !== "finished").sort());
  assert.deepEqual(await saidOf(page, [["ending", { ending: "not_finite", detail: "at step 7, t = 0.5" }], ["ending", { ending: "refused", detail: "needs a grid" }],
    ["ending", { ending: "melted_away", detail: "at step 3" }], ["judged", { verdict: "odd", ending: "finished" }]]),
  ["not finite at step 7, t = 0.5", "refused: needs a grid", "melted_away at step 3", "odd (finished)"]);
}));

const trials = [
  [{ verdict: "survives", error: 1.4e-9, rounding_from: 2, seconds: 0.0123 }, "✓ 1e-9", "l1, s: survives, 1.4e-9 of the value, rounding from t = 2 on, 12.3 ms"],
  [{ verdict: "fails", ending: "not_finite", detail: "at step 3, t = 0.5" }, "✗", "l1, s: fails, not finite at step 3, t = 0.5"],
  [{ verdict: "refuses", ending: "refused", detail: "takes orders in (0, 2]" }, "–", "l1, s: refuses, takes orders in (0, 2]"],
  [{ verdict: "puzzles", ending: "melted_away", error: 0.5, seconds: 1, wall_clock: true }, "puzzles 5e-1", "l1, s: puzzles, melted_away, 5.0e-1 of the value, 1.00 s of the wall clock"],
  [null, "not run", ""],
  [{ survive: 2, trials: 5, stop: 1, refused: 2 }, "2 of 5", "stops rightly 1, refuses 2"],
  [{ survive: 0, trials: 5, refused: 2 }, "0 of 5", "refuses 2"],
];
test("a trial has a sign and its reason; an unknown verdict is shown by its id", () => withReadPage("", async (page) => {
  const content = await page.evaluate((cells) => {
    const table = tableOfFacts(sectionTables.stability, [{ rows: cells.map((cell) => ({ scene: "s", steps: 64, cells: [cell] })) }], { lines: ["l1"] });
    return [...tableFrame(table, ["l1"]).querySelectorAll("td")].map((cell) => [cell.textContent, cell.title]);
  }, trials.map(([cell]) => cell));
  assert.deepEqual(content, trials.map(([, ...texts]) => texts));
}));

test("templates name formats that there are", () => withReadPage("", async (page) => {
  const unknown = await page.evaluate(() => {
    const textsIn = (of) => (typeof of === "string" ? [of] : of && typeof of === "object" ? Object.values(of).flatMap(textsIn) : []);
    const known = { ...numberFormats, ...wholeFormats, ...statements };
    return [statements, sectionTexts, sectionTables].flatMap(textsIn).flatMap((text) => [...text.matchAll(/\{[^}]*?:(\w+)/g)].map(([, format]) => format)).filter((format) => !known[format]);
  });
  assert.deepEqual(unknown, []);
}));
