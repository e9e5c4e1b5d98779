// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { RESULTS, settled, withPage } from "./browser.js";
import { sectionOf } from "./charts.js";
import { finished, runsOf } from "./records.js";

const runs = runsOf(RESULTS);

// What the controls requested for in the test below.
async function checkView(page) {
  await settled(page);
  assert.equal(await page.inputValue("#norm"), "end");
  assert.equal(await page.inputValue("#scene"), "pend");
  assert.match(await page.locator("#of-schemes summary").textContent(), /^Schemes: 2 of \d$/);
  assert.deepEqual(await page.locator("#answer .map thead th").allTextContents(), ["scene", "≤ 1e-6"]);
  assert.deepEqual(await page.locator("#answer .map tbody th").allTextContents(), ["Pendulum with fractional damping"]);
  assert.equal(await sectionOf(page, "relaxation").isVisible(), false);
  const section = sectionOf(page, "pendulum");
  assert.equal(await section.locator(":scope > details > div > .frame tbody tr").count(), 1);
  const drawn = await section.locator('figure[data-chart="error-against-time"] .mark-symbol.role-mark path').evaluateAll((marks) => marks.map((mark) => mark.__data__.datum.line));
  const expected = finished(runs).filter((run) => run.scene === "pendulum" && ["l1", "bdf4"].includes(run.scheme) && run.error_end_mixed > 0);
  assert.equal(drawn.length, expected.length);
  assert.deepEqual([...new Set(drawn)].sort(), ["bdf4", "l1"]);
}

test("scenes, schemes, norms and accuracies are chosen, and a link restores the view", () => {
  let address;
  return withPage({ address: "#scene-pendulum" }, async (page) => {
    await settled(page);
    await page.fill("#scene", "pend");
    await page.locator("#scene").blur();
    await page.selectOption("#norm", "end");
    await page.selectOption("#accuracy", "1e-6");
    await page.locator("#of-schemes summary").click();
    await page.getByRole("button", { name: "none" }).click();
    for (const scheme of ["l1", "bdf4"]) await page.getByLabel(scheme, { exact: true }).check();
    await checkView(page);
    address = decodeURIComponent(new URL(page.url()).hash);
    assert.equal(address, "#scene-pendulum?norm=end&accuracy=1e-6&scene=pend&schemes=bdf4,l1");  // in the order of the page
  }).then(() => withPage({ address }, async (page) => {
    await checkView(page);
    const top = await sectionOf(page, "pendulum").locator("h2").evaluate((node) => node.getBoundingClientRect().top);
    assert.ok(top > -5 && top < 200, `the heading is at ${top} pixels`);
  }));
});

test("an address with a broken escape shows the page", () =>
  withPage({ address: "#%E0%A4%A" }, async (page) => {
    await page.locator("#answer .map").first().waitFor();
    await page.locator("main:not([aria-busy=true])").waitFor();
  }));
