// SPDX-License-Identifier: MIT
// Whatever the controls choose, what is said follows, no section is empty, and nothing is wider than a phone.
import assert from "node:assert/strict";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { PAGE, drawAll, withPage } from "./browser.js";

// What of the page says nothing: a heading before nothing, a section, a list, a table or a chart without content, a link to what is hidden.
const blanks = (page) => page.evaluate(() => {
  const isShown = (node) => node.getClientRects().length > 0, all = (selector) => [...document.querySelectorAll(selector)].filter(isShown);
  const found = [
    ...all("main > section").filter((section) => section.firstChild.open && !section.querySelector("td, figure, .left")).map((section) => `section ${section.id}`),
    ...all("main h3").filter((heading) => !heading.nextElementSibling?.textContent.trim()).map((heading) => `heading ${heading.textContent}`),
    ...all("main dl, main tbody").filter((list) => list.children.length === 0).map((list) => `${list.tagName} in ${list.closest("section").id}`),
    ...all("main table").filter((table) => !table.querySelector("tbody td")).map((table) => `table in ${table.closest("section").id}`),
    ...all("main figure").filter((figure) => !figure.querySelector("svg .role-mark path")).map((figure) => `chart ${figure.dataset.chart}`),
    ...all("nav a").filter((link) => !isShown(document.getElementById(link.hash.slice(1)))).map((link) => `link ${link.textContent}`),
    ...all("main p").filter((text) => !text.textContent.trim()).map((text) => `paragraph in ${text.closest("section").id}`),
  ];
  return [...found, ...(document.documentElement.scrollWidth > innerWidth ? [`${document.documentElement.scrollWidth} pixels wide`] : [])];
});

const choices = [
  { norm: "end", scale: "absolute" }, { scale: "relative", accuracy: "1e-12" }, ...["pend", "relax", "stiff", "nowhere"].map((scene) => ({ scene })),
  ...["l1", "spectral_collocation"].map((schemes) => ({ schemes })), { scene: "pend", schemes: "bdf4", accuracy: "1e-12", norm: "end" },
];

test("no choice leaves a blank, an empty chart or a dead link", () =>
  withPage({ width: 390, height: 844 }, async (page) => {
    for (const choice of choices) {
      await page.evaluate((of) => { location.hash = `#?${new URLSearchParams(of)}`; }, choice);
      await page.waitForFunction((of) => Object.entries(of).every(([name, value]) => String(viewNow()[name]) === value), choice);
      await drawAll(page);
      assert.deepEqual(await blanks(page), [], JSON.stringify(choice));
    }
  }));

test("a choice that leaves nothing says so, and a button takes it back", () =>
  withPage({ width: 390, height: 844 }, async (page) => {
    assert.equal(await page.locator("#shown").isVisible(), false);
    const scenes = await page.locator("#answer tbody tr").count();
    await page.fill("#scene", "nowhere");
    await page.locator("#scene").press("Enter");
    assert.match(await page.getByRole("status").textContent(), /^Nothing is left: no scene has “nowhere” in its name\. Show everything$/);
    assert.equal(await page.locator("#answer").isVisible(), false);
    await page.getByRole("button", { name: "Show everything" }).click();
    assert.equal(await page.locator("#shown").isVisible(), false);
    assert.equal(await page.locator("#answer tbody tr").count(), scenes);
    assert.equal(new URL(page.url()).hash.includes("?"), false);
  }));

test("what is said beside the map is of what the controls choose", () =>
  withPage({}, async (page) => {
    const said = () => page.locator("#answer .said").allTextContents().then((all) => all.join(" "));
    const cells = (of) => /Cheapest in \d+ of (\d+) cells/.exec(of)?.[1], shown = () => page.locator("#answer .map td:not(.faint) b").count();
    const all = await said();
    await page.selectOption("#accuracy", "1e-6");
    const atAccuracy = await said();
    assert.equal(Number(cells(atAccuracy)), await shown());
    assert.ok(Number(cells(atAccuracy)) < Number(cells(all)));
    assert.doesNotMatch(atAccuracy, /nearest on/);
    await page.selectOption("#norm", "end");
    assert.match(await page.locator("#answer caption").textContent(), /error at the end/);
    await page.selectOption("#scale", "absolute");
    assert.doesNotMatch(await page.locator("#answer caption").textContent(), /mixed/);
    await page.fill("#scene", "pendulum");
    await page.locator("#scene").press("Enter");
    const ofScene = await said();
    assert.equal(cells(ofScene), "1");
    assert.doesNotMatch(ofScene, /relaxation|loxodrome|trial/);
    await page.evaluate(() => { for (const box of schemeBoxes()) box.checked = box.value === "l1"; document.getElementById("view").dispatchEvent(new Event("change")); });
    assert.deepEqual(await page.locator("#answer .said dt").allTextContents(), ["l1"]);
    assert.match(await page.getByRole("status").textContent(), /^Shown: 1 of \d+ scenes, 1 of \d+ schemes, errors to 1e-6\. Cells of other schemes are faint\./);
    assert.match(await page.locator('[id="scene-pendulum"] .conclusion').textContent(), /^Of all runs, whatever is chosen above:/);
  }));

test("a choice of a machine is said, and scenes without its runs say so", () =>
  withPage({ page: join(dirname(PAGE), "machines", "index.html"), width: 390, height: 844, address: "#?machine=an older machine" }, async (page) => {
    await drawAll(page);
    assert.match(await page.getByRole("status").textContent(), /runs of an older machine\. Cells of other machines are faint\./);
    assert.deepEqual(await blanks(page), []);
    const [cells, faint] = [await page.locator("#answer .map td b").count(), await page.locator("#answer .map td.faint b").count()];
    const said = (await page.locator("#answer .said").allTextContents()).join(" ");
    assert.equal(/Cheapest in/.test(said), cells > faint);
    assert.match(await page.locator('[id="scene-pendulum"] .left').textContent(), /^None of the chosen runs is of this scene\. Show everything$/);
  }));
