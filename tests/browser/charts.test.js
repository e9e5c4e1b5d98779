// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { drawAll, RESULTS, settled, withPage, withReadPage } from "./browser.js";
import { checkCharts, sectionOf } from "./charts.js";
import { errorText, finished, runsOf } from "./records.js";

const runs = runsOf(RESULTS);
const shown = "error_maximum_mixed"; // what the page begins with

test("every chart has the marks of its records, and those of another norm and scale", () =>
  withPage({}, async (page) => {
    // Before all sections are drawn, which are drawn again for each choice.
    await page.selectOption("#norm", "end");
    await page.selectOption("#scale", "absolute");
    await drawAll(page);
    await checkCharts(page, runs, "error_end");
    assert.match(await page.locator("#answer caption").first().textContent(), /scene and error at the end$/);
    await page.evaluate(() => { location.hash = "#?scale=mixed"; });
    await page.waitForFunction(() => viewNow().scale === "mixed" && viewNow().norm === "maximum");
    await settled(page);
    await checkCharts(page, runs, shown);
  }));

test("errors over a parameter have a point for each line and value", () =>
  withReadPage("#curve-relaxation-gamma", async (page) => {
    await settled(page);
    const most = Math.max(...finished(runs).map(({ steps }) => steps));
    const expected = finished(runs).filter((run) => run.scene.startsWith("relaxation") && run.steps === most);
    for (const chart of ["error-over-parameter", "time-over-parameter"]) {
      assert.equal(await page.locator(`#curve-relaxation-gamma figure[data-chart="${chart}"] .mark-symbol.role-mark path`).count(), expected.length, chart);
    }
  }));

const ofPendulum = finished(runs).filter(({ scene }) => scene === "pendulum");
const linesIn = (figure) => figure.evaluate((node) => [...new Set([...node.querySelectorAll(".mark-symbol.role-mark path")].map((path) => path.__data__.datum.line))]);

test("of many lines a chart begins with those on the Pareto front, and a button draws all", () =>
  withPage({ address: "#scene-pendulum?scene=pendulum", changed: ["const mostLines = 6, firstLines = 5;", "const mostLines = 3, firstLines = 2;"] }, async (page) => {
    await settled(page);
    const section = sectionOf(page, "pendulum"), figure = section.locator('figure[data-chart="error-against-time"]');
    const all = [...new Set(ofPendulum.map(({ scheme }) => scheme))], front = await page.evaluate(() => {
      const [section] = data.sections.filter(({ id }) => id === "scene-pendulum");
      return paretoFront(pointsOf(section, chosenKind(data.kinds), data.kinds).filter(({ error, time_minimum }) => error && time_minimum), "time_minimum").map(({ line }) => line);
    });
    const first = await linesIn(figure);
    assert.equal(first.length, 2);
    for (const line of first) assert.ok(front.includes(line), line);
    assert.match(await section.locator("p.left").textContent(), new RegExp(`^The charts show 2 of ${all.length} lines`));
    await section.getByRole("button", { name: `All ${all.length}` }).click();
    await settled(page);
    assert.deepEqual((await linesIn(figure)).sort(), all.sort());
    await section.getByRole("button", { name: "Only the 2" }).click();
    await settled(page);
    assert.deepEqual(await linesIn(figure), first);
  }));

test("each line has its name beside it, and no two names meet", () =>
  withReadPage("#scene-pendulum", async (page) => {
    await settled(page);
    for (const chart of ["error-against-time", "error-against-step", "error-against-memory"]) {
      const figure = sectionOf(page, "pendulum").locator(`figure[data-chart="${chart}"]`), lines = await linesIn(figure);
      const labels = await figure.evaluate((node) => [...node.querySelectorAll(".mark-text.role-mark text")].map((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        return { name: text.textContent, left, right, top, bottom };
      }));
      assert.deepEqual(labels.map(({ name }) => name).sort(), [...lines].sort(), chart);
      const meet = labels.filter((a, i) => labels.slice(i + 1).some((b) => a.left < b.right && b.left < a.right && a.top + 3 < b.bottom && b.top + 3 < a.bottom));
      assert.deepEqual(meet, [], chart);
    }
  }));

test("the band in the chart of errors and times is the Pareto front", () =>
  withReadPage("#scene-pendulum", async (page) => {
    await settled(page);
    const timed = ofPendulum.filter((run) => run[shown] > 0 && run.time_minimum > 0);
    const front = timed.filter((run) => !timed.some((other) => other !== run && other.time_minimum <= run.time_minimum && other[shown] <= run[shown]));
    const data = await sectionOf(page, "pendulum").locator('figure[data-chart="error-against-time"]').evaluate((node) =>
      [...node.querySelectorAll(".mark-line.role-mark path")].map((path) => path.__data__).find(({ mark }) => mark.items.every(({ datum }) => !datum.line)).mark.items.length);
    assert.equal(data, front.length);
  }));

test("regions of stability follow the order that is chosen", () =>
  withPage({ address: "#regions?scene=none" }, async (page) => {
    await settled(page);
    const figure = page.locator('#regions figure[data-chart="stability-regions"]');
    const reach = () => figure.evaluate((node) => {
      const [mark] = [...node.querySelectorAll(".mark-symbol.role-mark path")].filter((path) => path.__data__.datum.line === "grunwald_letnikov").map((path) => path.__data__.datum);
      return mark.order;
    });
    assert.equal(await reach(), 0.5);
    await figure.locator('input[type="range"]').fill("1.5");
    await page.waitForTimeout(200);
    assert.equal(await reach(), 1.5);
  }));

// A point that no other covers, in the middle of the window.
const visiblePoint = (figure) =>
  figure.evaluate((node) => {
    node.scrollIntoView({ block: "center" });
    for (const mark of node.querySelectorAll(".mark-symbol.role-mark path")) {
      const { x, y, width, height } = mark.getBoundingClientRect();
      const place = { x: x + width / 2, y: y + height / 2 };
      if (document.elementFromPoint(place.x, place.y) === mark) return { ...place, line: mark.__data__.datum.line, steps: mark.__data__.datum.steps };
    }
    return null;
  });

test("hovering tells the run under the pointer", () =>
  withReadPage("#scene-pendulum", async (page) => {
    await settled(page);
    for (const [scene, chart] of [["pendulum", "error-against-time"], ["loxodrome", "error-against-step"], ["pendulum", "energy-against-step"]]) {
      const point = await visiblePoint(sectionOf(page, scene).locator(`figure[data-chart="${chart}"]`));
      await page.mouse.move(point.x, point.y);
      const run = finished(runs).find((one) => one.scene === scene && one.scheme === point.line && one.steps === point.steps);
      const tooltip = page.locator("#vg-tooltip-element.visible");
      await tooltip.waitFor();
      assert.equal(await tooltip.locator("h2").textContent(), run.scheme);
      const words = Object.fromEntries(await tooltip.locator("tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent.replace(/:$/, "")))));
      assert.equal(words.N, String(run.steps));
      assert.equal(words["maximum error"], errorText(run.error_maximum));
      assert.equal(words["relative error at the end"], errorText(run.error_end_relative));
      assert.equal(words["calls of f"], String(Number(run.rhs_calls.toPrecision(3))));
      assert.ok(words.machine && words.date);
      await page.mouse.move(0, 0);
    }
  }));

test("a click in the legend leaves one line bright", () =>
  withPage({ address: "#scene-pendulum?scene=pendulum" }, async (page) => {
    await settled(page);
    const figure = sectionOf(page, "pendulum").locator('figure[data-chart="error-against-time"]');
    const brightLines = () => figure.evaluate((node) => [...new Set([...node.querySelectorAll(".mark-symbol.role-mark path")]
      .filter((mark) => Number(mark.getAttribute("opacity") ?? 1) > 0.5).map((mark) => mark.__data__.datum.line))].sort());
    const all = await brightLines();
    assert.ok(all.length > 2);
    await figure.locator(".role-legend-label text", { hasText: /^l1$/ }).click();
    await page.waitForTimeout(100);
    assert.deepEqual(await brightLines(), ["l1"]);
  }));

test("the numbers behind a chart are a table and a file", () =>
  withReadPage("#scene-pendulum", async (page) => {
    await settled(page);
    const figure = sectionOf(page, "pendulum").locator('figure[data-chart="delivered-against-requested"]');
    const requested = finished(runs).filter((run) => run.scene === "pendulum" && run.requested);
    const rows = await figure.locator("tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map((row) => row.slice(0, 3)), requested.map((run) => [run.scheme, errorText(run.requested), errorText(run[shown])]));
    const [download] = await Promise.all([page.waitForEvent("download"), figure.locator(".numbers > a").click()]);
    const lines = readFileSync(await download.path(), "utf8").trim().split("\n").map((line) => line.split(","));
    assert.deepEqual(lines[0], ["scheme", "requested", "mixed maximum error", "ratio", "N", "run time in s"]);
    assert.deepEqual(lines.slice(1).map(([, , error, , steps]) => [Number(error).toPrecision(4), steps]), requested.map((run) => [run[shown].toPrecision(4), String(run.steps)]));
  }));
