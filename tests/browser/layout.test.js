// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { violations } from "./accessible.js";
import { drawAll, SCREENSHOTS, settled, withPage } from "./browser.js";

// Of charts the frame, not each mark.
const marks = [["svg.marks > g"]];

const widerThanTheWindow = (page) =>
  page.evaluate(() => [...document.querySelectorAll("body *")]
    .filter((node) => node.getBoundingClientRect().right > innerWidth + 1 && !node.closest(".frame, nav, svg, details:not([open])"))
    .map((node) => `${node.tagName} ${node.className}: ${node.textContent.slice(0, 40)}`).slice(0, 5));

// A4 with its margins, upright and across.
const paper = { upright: 695, across: 1022 };
const wide = "#stability, #drift, #reference, #rates, #compared";

test("a printed page has nothing that is cut off", () =>
  withPage({ address: "#?all" }, async (page) => {
    await drawAll(page);
    await page.emulateMedia({ media: "print" });
    for (const [way, width] of Object.entries(paper)) {
      await page.setViewportSize({ width, height: 900 });
      await settled(page);
      const cut = await page.evaluate(([isWide, sections]) => [...document.querySelectorAll("main td, main th, main figure, main svg, main p, main math")]
        .filter((node) => Boolean(node.closest(sections)) === isWide && node.getBoundingClientRect().right > innerWidth + 1)
        .map((node) => `${node.closest("section").id}: ${node.tagName} ${node.textContent.slice(0, 40)}`).slice(0, 5), [way === "across", wide]);
      assert.deepEqual(cut, [], way);
    }
    await page.pdf({ path: join(SCREENSHOTS, "page.pdf"), preferCSSPageSize: true });
  }));

for (const dark of [false, true]) {
  const colours = dark ? "dark" : "light";
  test(`nothing is cut off, and everyone can read it: ${colours}`, () =>
    withPage({ dark, address: "#scene-pendulum" }, async (page) => {
      await (dark ? settled : drawAll)(page);
      for (const width of dark ? [1280, 400] : [1280, 700, 400]) {
        await page.setViewportSize({ width, height: 900 });
        await page.evaluate(() => scrollTo(0, 0));
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
        assert.deepEqual(await widerThanTheWindow(page), [], `at ${width} pixels`);
        await settled(page);
        await page.screenshot({ path: join(SCREENSHOTS, `first_${width}_${colours}.png`) });
        await page.locator('[id="scene-pendulum"]').screenshot({ path: join(SCREENSHOTS, `scene_${width}_${colours}.png`) });
        if (width === (dark ? 1280 : 400)) assert.deepEqual(await violations(page, marks), [], `at ${width} pixels`);
      }
    }));
}
