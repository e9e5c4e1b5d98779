// SPDX-License-Identifier: MIT
// node measure.js PAGE...: how large pages of `fdebench report` are, and after how long they show their answer and a first chart, in
// headless Chromium in the windows of a notebook and of a phone: the least of five times each. No test: a busy machine takes longer.
import { statSync } from "node:fs";
import { resolve } from "node:path";
import { chromium } from "playwright-core";

const repeats = 5;
const windows = [{ width: 1280, height: 800 }, { width: 390, height: 844 }];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });

// Milliseconds from the request to the first frame behind which the selector is there.
async function shownAfter(file, viewport, address, selector) {
  const context = await browser.newContext({ viewport });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.addInitScript((wanted) => {
    const look = () => (document.querySelector(wanted) ? (globalThis.shown = performance.now()) : requestAnimationFrame(look));
    requestAnimationFrame(look);
  }, selector);
  await page.goto(`file://${resolve(file)}${address}`);
  await page.waitForFunction(() => globalThis.shown);
  const milliseconds = await page.evaluate(() => globalThis.shown);
  const scene = await page.evaluate(() => document.querySelector("#answer tbody th a")?.getAttribute("href"));
  await context.close();
  return { milliseconds, scene };
}

async function least(...what) {
  const times = [];
  for (let i = 0; i < repeats; ++i) times.push(await shownAfter(...what));
  return { milliseconds: Math.round(Math.min(...times.map((of) => of.milliseconds))), scene: times[0].scene };
}

for (const file of process.argv.slice(2)) {
  console.log(`${file}: ${(statSync(file).size / 1e6).toFixed(2)} MB`);
  for (const window of windows) {
    const answer = await least(file, window, "", "#answer .map td b");
    const chart = await least(file, window, answer.scene, "figure[data-chart] svg .role-mark path");
    console.log(`  at ${window.width} x ${window.height}: answer after ${answer.milliseconds} ms, a scene's first chart after ${chart.milliseconds} ms`);
  }
}
await browser.close();
