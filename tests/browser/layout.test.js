// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { violations } from "./accessible.js";
import { drawAll, screenshot, SCREENSHOTS, settled, withPage } from "./browser.js";

// Of charts the frame, not each mark.
const marks = { away: "svg.marks > g" };

const widerThanTheWindow = (page) =>
  page.evaluate(() => [...document.querySelectorAll("body *")]
    .filter((node) => node.getBoundingClientRect().right > innerWidth + 1 && !node.closest(".frame, nav, svg, details:not([open])"))
    .map((node) => `${node.tagName} ${node.className}: ${node.textContent.slice(0, 40)}`).slice(0, 5));

// A4 with its margins, upright and across.
const upright = 695, across = 1022;
const wide = "#stability, #drift, #reference, #rates, #compared";

async function checkPaper(page, width) {
  await page.emulateMedia({ media: "print" });
  const cut = await page.evaluate(([isWide, sections]) => [...document.querySelectorAll("main td, main th, main figure, main svg, main p, main math")]
    .filter((node) => Boolean(node.closest(sections)) === isWide && node.getBoundingClientRect().right > innerWidth + 1)
    .map((node) => `${node.closest("section").id}: ${node.tagName} ${node.textContent.slice(0, 40)}`).slice(0, 5), [width === across, wide]);
  assert.deepEqual(cut, [], `on paper, ${width} pixels`);
  if (width === upright) await page.pdf({ path: join(SCREENSHOTS, "page.pdf"), preferCSSPageSize: true });
  await page.emulateMedia({ media: "screen" });
}

async function checkScreen(page, width, colours) {
  await page.evaluate(() => scrollTo(0, 0));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
  assert.deepEqual(await widerThanTheWindow(page), [], `at ${width} pixels`);
  await page.screenshot({ path: join(SCREENSHOTS, `first_${width}_${colours}.png`) });
  await screenshot(page.locator('[id="scene-pendulum"]'), join(SCREENSHOTS, `scene_${width}_${colours}.png`));
}

// A window that changes its width draws all charts again: each width once.
for (const [colours, widths, accessible] of [["light", [1280, across, upright, 400], 400], ["dark", [1280, 400], 1280]]) {
  test(`nothing is cut off, on paper neither, and everyone can read it: ${colours}`, () =>
    withPage({ dark: colours === "dark", address: "#scene-pendulum" }, async (page) => {
      if (colours === "light") await drawAll(page);
      for (const width of widths) {
        await page.setViewportSize({ width, height: 900 });
        await settled(page);
        await checkScreen(page, width, colours);
        if (colours === "light" && [upright, across].includes(width)) await checkPaper(page, width);
        if (width === accessible) assert.deepEqual(await violations(page, marks), [], `at ${width} pixels`);
      }
    }));
}
