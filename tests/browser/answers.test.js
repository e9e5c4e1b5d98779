// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { RESULTS, settled, withPage, withReadPage } from "./browser.js";
import { sectionOf } from "./charts.js";
import { errorText, finished, isTrial, runsOf, scenesOf } from "./records.js";

const runs = runsOf(RESULTS);

const topOf = (heading) => heading.evaluate((node) => node.getBoundingClientRect().top);
const near = (top) => assert.ok(top > -5 && top < 120, `the heading is at ${top} pixels`);

test("the first screen has the answer of every scene, the cheapest run in each cell", () =>
  withReadPage("", async (page) => {
    const table = page.locator("#answer table.map");
    assert.equal(await table.locator("tbody tr").count(), scenesOf(runs).length);
    assert.ok((await table.boundingBox()).y < 400);
    const row = table.locator("tbody tr", { has: page.locator('th a[href="#scene-pendulum"]') });
    for (const [column, accuracy] of [[0, 1e-2], [2, 1e-6]]) {
      const within = finished(runs).filter((run) => run.scene === "pendulum" && run.error_maximum_mixed <= accuracy && !run.baseline_maximum_mixed);
      const best = within.reduce((a, b) => (a.time_median < b.time_median ? a : b));
      const cell = row.locator("td").nth(column);
      assert.equal(await cell.locator("b").textContent(), best.scheme);
      assert.match(await cell.getAttribute("title"), new RegExp(`^${best.scheme}: .*N = ${best.steps}, `));
    }
    const least = Math.min(...finished(runs).filter(({ scene }) => scene === "pendulum").map((run) => run.error_maximum_mixed));
    assert.ok(least > 1e-12);
    assert.equal(await row.locator("td").last().textContent(), `best ${errorText(least)}`);
  }));

test("every id is there once, so that links lead where they say", () =>
  withReadPage("", async (page) => {
    const ids = await page.locator("[id]").evaluateAll((all) => all.filter((node) => !node.closest("svg")).map(({ id }) => id));
    assert.deepEqual(ids.filter((id, i) => ids.indexOf(id) !== i), []);
  }));

test("a cell of the map leads to its scene, and the way back to the map", () =>
  withPage({}, async (page) => {
    await page.locator("#answer tr", { has: page.locator('a[href="#scene-pendulum"]') }).locator("td button").first().click();
    await page.locator("#cell").getByRole("link").click();
    assert.equal(await page.locator("#cell").isVisible(), false);
    await settled(page);
    assert.equal(new URL(page.url()).hash, "#scene-pendulum");
    near(await topOf(sectionOf(page, "pendulum").locator("h2")));
    await page.goBack();
    near(await topOf(page.locator("#answer h2")) - 100);
  }));

test("a link to a scene opens there", () =>
  withPage({ address: "#scene-loxodrome" }, async (page) => {
    await settled(page);
    near(await topOf(sectionOf(page, "loxodrome").locator("h2")));
  }));

test("each scheme has a sentence on where it wins and where not to use it", () =>
  withReadPage("", async (page) => {
    const words = await page.locator("#answer .said dt").evaluateAll((names) => Object.fromEntries(names.map((name) =>
      [name.textContent, { wins: name.nextElementSibling.textContent, not: name.nextElementSibling.nextElementSibling.textContent }])));
    assert.deepEqual(Object.keys(words).sort(), ["adams_pc", "bdf4", "l1", "product_trapezoidal", "spectral_collocation"]);
    const accuracies = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
    const winners = scenesOf(runs).flatMap((scene) => accuracies.map((accuracy) => finished(runs)
      .filter((run) => run.scene === scene && run.error_maximum_mixed <= accuracy && !run.baseline_maximum_mixed && run.time_median)
      .reduce((a, b) => (!a || b.time_median < a.time_median ? b : a), null)).filter(Boolean));
    for (const [scheme, { wins }] of Object.entries(words)) {
      const won = winners.filter((run) => run.scheme === scheme).length;
      assert.match(wins, won > 0 ? new RegExp(`^Cheapest in ${won} of ${winners.length} cells: `) : /^(Cheapest nowhere|Reaches none)/, scheme);
    }
    assert.match(words.adams_pc.not, /^Fails on .*stiff_relaxation/);
  }));

test("trials have their verdict", () =>
  withReadPage("#stability", async (page) => {
    const trials = runs.filter(isTrial);
    const cells = page.locator("#stability tbody td[data-tone]");
    await cells.first().waitFor();
    assert.equal(await cells.count(), trials.length);
    const surviving = trials.filter((run) => run.ending === "finished" && run.error_relative <= 1e-2);
    assert.equal(await page.locator('#stability td[data-tone="survives"]').count(), surviving.length);
    // The smaller its error, the darker its colour.
    const shades = await page.locator('#stability td[data-tone="survives"]').evaluateAll((all) =>
      all.map((cell) => [parseFloat(cell.style.getPropertyValue("--strength")), Number(/, ([\d.e-]+) of the value/.exec(cell.title)[1])]).sort((a, b) => a[1] - b[1]).map(([shade]) => shade));
    assert.deepEqual(shades, [...shades].sort((a, b) => b - a));
  }));
