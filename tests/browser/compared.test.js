// SPDX-License-Identifier: MIT
// Pages of two results: side by side, and of two machines.
import assert from "node:assert/strict";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { PAGE, RESULTS, settled, withPage } from "./browser.js";
import { sectionOf } from "./charts.js";
import { finished, runsOf } from "./records.js";

const runs = runsOf(RESULTS);
const pageIn = (folder) => join(dirname(PAGE), folder, "index.html");

test("a page of two results says what changed, and leads to the scenes", () =>
  withPage({ page: pageIn("compared"), address: "#compared" }, async (page) => {
    const groups = await page.locator("#compared tr.group").allTextContents();
    const ofBdf4 = finished(runs).filter(({ scene, scheme }) => scene === "relaxation" && scheme === "bdf4");
    assert.equal(groups[0], `Verdicts and endings: ${ofBdf4.length}`);
    assert.match(groups[1], /^Errors: \d+/);
    const errors = page.locator("#compared tbody").nth(1).locator("tr:not(.group)");
    assert.deepEqual([...new Set(await errors.locator("th").allTextContents())], ["pendulum"]);
    assert.ok((await errors.locator("mark").allTextContents()).every((text) => /× (2|1\.99|2\.0\d?)$/.test(text)));
    await errors.locator("a").first().click();
    await settled(page);
    assert.equal(new URL(page.url()).hash, "#scene-pendulum");
    // The rest of the page is of the second results.
    const figure = sectionOf(page, "relaxation").locator('figure[data-chart="error-against-step"]');
    await sectionOf(page, "relaxation").scrollIntoViewIfNeeded();
    await figure.locator(".mark-symbol.role-mark path").first().waitFor({ state: "attached" });
    const drawn = await figure.locator(".mark-symbol.role-mark path").evaluateAll((marks) => marks.filter((mark) => mark.__data__.datum.line === "bdf4").length);
    assert.equal(drawn, ofBdf4.filter((run) => !run.requested).length);
  }));

test("results of several machines are shown of one", () =>
  withPage({ page: pageIn("machines"), address: "#scene-pendulum" }, async (page) => {
    await settled(page);
    const names = await page.locator("#machine option").allTextContents();
    assert.equal(names.length, 3);
    const points = () => sectionOf(page, "pendulum").locator('figure[data-chart="error-against-time"] .mark-symbol.role-mark path').count();
    assert.ok((await points()) > 0);
    assert.equal(await page.locator("#answer .map td.faint").count(), 0);
    await page.selectOption("#machine", "an older machine");
    await page.waitForFunction(() => document.querySelectorAll("#answer .map td.faint").length > 0);
    assert.equal(await sectionOf(page, "pendulum").locator('figure[data-chart="error-against-time"]').count(), 0);
    assert.match(decodeURIComponent(new URL(page.url()).hash), /\?machine=an%20older%20machine$|\?machine=an older machine$/);
  }));
