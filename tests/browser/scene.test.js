// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { RESULTS, drawAll, settled, withReadPage } from "./browser.js";
import { sectionOf } from "./charts.js";
import { finished, runsOf } from "./records.js";

const runs = runsOf(RESULTS);

test("a scene has its equation, its solution and a conclusion", () =>
  withReadPage("#scene-pendulum", async (page) => {
    await settled(page);
    const section = sectionOf(page, "pendulum");
    assert.equal(await section.locator("math").count(), 1);
    assert.equal((await section.locator("math").textContent()).replaceAll(/\s/g, ""), "φ″+μταDαφ+λτφ′+ντβDβφ=−gLsin(φ)");
    assert.ok((await section.locator("math").boundingBox()).height > 20);
    const lines = await section.locator('figure[data-chart="solution"] .mark-line.role-mark path').evaluateAll((paths) => paths.map((path) => path.getAttribute("d").length));
    assert.equal(lines.length, 4);
    assert.ok(lines.every((length) => length > 1000));
    assert.match(await section.locator('figure[data-chart="phase-portrait"] figcaption').textContent(), /^φ′ against φ/);
    const within = finished(runs).filter((run) => run.scene === "pendulum" && run.error_maximum_mixed <= 1e-6);
    const best = within.reduce((a, b) => (a.time_median < b.time_median ? a : b));
    assert.match(await section.locator(".conclusion").textContent(), new RegExp(`${best.scheme} (from|to) 1e-\\d`));
  }));

test("a formula says from where a derivative looks", () =>
  withReadPage("", async (page) => {
    const set = await page.evaluate(() => {
      const made = equation({ left: "D_right(p, alpha) + sum(k, b_k*D(u, 1))", right: "J(mu, 1 - alpha)" });
      return { text: made.textContent, sided: made.querySelectorAll("msubsup").length, alternative: made.getAttribute("alttext") };
    });
    assert.deepEqual(set, {
      text: "tDTαp+∑kbku′=J1−αμ",
      sided: 1,
      alternative: "D_right(p, alpha) + sum(k, b_k*D(u, 1)) = J(mu, 1 - alpha)",
    });
  }));

test("a constrained scene has its multiplier, its constraint and its motion", () =>
  withReadPage("#scene-loxodrome", async (page) => {
    await drawAll(page);
    const section = sectionOf(page, "loxodrome");
    const equations = await section.locator("math").allTextContents();
    assert.equal(equations.length, 3);
    assert.equal(equations.at(-1).replaceAll(/\s/g, ""), "0=sin(θ)φ′−kθ′");
    for (const chart of ["motion", "multipliers"]) {
      assert.equal(await section.locator(`figure[data-chart="${chart}"] .mark-line.role-mark path`).count() > 0, true, chart);
    }
    // Its energy is kept: there is nothing to see.
    assert.equal(await section.locator('figure[data-chart="energy-over-time"]').count(), 0);
    assert.equal(await sectionOf(page, "pendulum").locator('figure[data-chart="energy-over-time"]').count(), 1);
  }));
