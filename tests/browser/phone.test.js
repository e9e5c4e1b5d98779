// SPDX-License-Identifier: MIT
// What a reader with a phone has, and what each recommendation gives: names in full, a command to copy.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { PAGE, settled, withPage } from "./browser.js";
import { sectionOf } from "./charts.js";

const { PROGRAM } = process.env;
const machine = "a machine whose name is much longer than a telephone is wide, as those of processors are";

test("a page with long names of machines and scenes is as wide as a phone", () =>
  withPage({ width: 390, page: join(dirname(PAGE), "machines", "index.html"), changed: [JSON.stringify("an older machine"), JSON.stringify(machine)] }, async (page) => {
    await page.locator("#machine").waitFor();
    await page.evaluate((of) => {
      document.querySelector("#machine").append(Object.assign(document.createElement("option"), { textContent: of }));
      for (const code of document.querySelectorAll("h2 code")) code.textContent = `linear_system:${"gamma1=0.7089,".repeat(12)}`;
    }, machine);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  }));

for (const width of [390, 1280]) {
  test(`short names of the map are said in full beside it: ${width}`, () =>
    withPage({ width }, async (page) => {
      const shown = new Set(await page.locator("#answer .map td b").allTextContents());
      const key = await page.locator("#answer .key").textContent();
      const names = await page.evaluate(() => Object.fromEntries(data.lines.map((line) => [shortNameOfLine(line), line])));
      for (const short of shown) if (names[short] !== short) assert.ok(key.includes(`${short} ${names[short]}`), `${short} in ${key}`);
      assert.ok(await page.locator("#answer .key").isVisible());
    }));
}

test("each recommendation is a command that runs, and a button copies it", () =>
  withPage({ address: "#scene-pendulum" }, async (page) => {
    await settled(page);
    const rows = sectionOf(page, "pendulum").locator(":scope > div > .frame tbody tr", { has: page.locator(".swatch") });
    assert.ok(await rows.count() > 2);
    assert.equal(await rows.locator(".command").count(), await rows.count());
    const row = rows.first(), text = await row.locator(".command code").textContent();
    const steps = /N = (\d+)/.exec(await row.textContent())[1];
    assert.match(text, /^fdebench solve pendulum --scheme \w+ --(steps|accuracy) /);
    const cost = execFileSync(PROGRAM, [...text.split(" ").slice(1), "--points", "2"].filter((word, i, all) => !text.includes("--accuracy") || i < all.length - 2), { encoding: "utf8" });
    assert.match(cost, /^t,phi,/);
    if (text.includes("--steps")) assert.ok(text.includes(`--steps ${steps}`));
    await page.evaluate(() => { document.addEventListener("copy", () => { globalThis.copied = getSelection().toString(); });
      Object.defineProperty(navigator, "clipboard", { value: { writeText: (of) => { globalThis.copied = of; return Promise.resolve(); } } }); });
    await row.locator(".command button").click();
    assert.equal(await page.evaluate(() => globalThis.copied), text);
    assert.equal(await row.locator(".command button").textContent(), "Copied");
  }));

test("what is said of schemes, trials and references follow the filters, with no blank beside", () =>
  withPage({ address: "#answer?accuracy=1e-4&scene=pendulum&schemes=l1,bdf4&all" }, async (page) => {
    await settled(page);
    const said = await page.locator("#answer .said dd").allTextContents();
    const cells = said.map((text) => /^Cheapest in \d+ of (\d+) cells: (.*?)\./.exec(text)).filter(Boolean);
    for (const [, count, scenes] of cells) assert.deepEqual([count, scenes], ["1", "pendulum"]);
    assert.ok(said.length > 0);
    assert.equal(await page.locator("#stability").isVisible(), false);
    for (const id of ["reference", "expansion"]) {
      const headings = page.locator(`#${id} tbody th`);
      for (const text of await headings.allTextContents()) assert.match(text, /pendulum/i, id);
    }
    // Nothing is left blank beneath the map: the last sentences begin at the left edge, or all fit beside it.
    const [map, last] = await Promise.all([page.locator("#answer .mapped").boundingBox(), page.locator("#answer .said > div").last().boundingBox()]);
    assert.ok(last.y + last.height - (map.y + map.height) < 400);
  }));

test("trials are of the schemes that are wanted", () =>
  withPage({ address: "#stability?schemes=l1,bdf4&all" }, async (page) => {
    await settled(page);
    assert.deepEqual((await page.locator("#stability thead tr").last().locator("th").allTextContents()).slice(1).sort(), ["bdf4", "l1"]);
  }));
