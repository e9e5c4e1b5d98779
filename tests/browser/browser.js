// SPDX-License-Identifier: MIT
// Pages in a headless browser, one for all tests of a process. Whatever a test does, the page must not complain.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before } from "node:test";
import { chromium } from "playwright-core";
import { repacked, unpackedFrom } from "./packed.js";

const patience = 120_000; // milliseconds; a busy machine draws slowly

export const { CHROMIUM, PAGE, RESULTS, SCREENSHOTS } = process.env;

// All pages are of one process, which compiles the library of charts once. Threads beside it that compile scripts and collect garbage take
// more time than they save.
const args = ["--no-sandbox", "--disable-gpu", "--renderer-process-limit=1", "--js-flags=--single-threaded"];

let browser, context;
const newContext = () => browser.newContext({ reducedMotion: "reduce", acceptDownloads: true });
before(async () => {
  browser = await chromium.launch({ executablePath: CHROMIUM, args });
  context = await newContext();
  await context.newPage();  // the process ends with its last page
});
after(() => browser.close());

function complaintsOf(page) {
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks the network for ${request.url()}`);
  });
  return complaints;
}

// The text with another in the place of one that it has.
function exchanged(text, [old, other]) {
  assert.ok(text.includes(old), `the page has no ${old}`);
  return text.replace(old, () => other);
}

// Opens the page and calls visit with it. address: what follows the file, "#scene-relaxation". changed, changedData: a text of the file, or
// of its data, and its replacement. prepare: is run before the page's scripts. apart: what pages store is not of other pages.
export async function withPage(how, visit) {
  const opened = await open(how);
  try {
    await visited(opened, visit);
  } finally {
    await (how.apart ? opened.page.context() : opened.page).close();
  }
}

// As withPage, for a test that only reads a page: it is opened once for all of them of a process.
const idle = new Map();
export async function withReadPage(address, visit, how = {}) {
  const key = JSON.stringify(how), opened = idle.get(key) ?? await open(how), { page } = opened;
  idle.delete(key);
  await page.evaluate((place) => { location.hash = place; if (!place) scrollTo(0, 0); }, address);
  const stateOf = () => page.evaluate(() => JSON.stringify([viewNow(), document.querySelector("#answer").innerText]));
  const state = await stateOf();
  await visited(opened, visit);
  assert.equal(await stateOf(), state, "the test has changed the page");
  idle.set(key, opened);
}

async function open({ width = 1280, height = 900, dark = false, address = "", changed, changedData, prepare, apart, page: file = PAGE }) {
  const page = await (apart ? await newContext() : context).newPage();
  page.setDefaultTimeout(patience);
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: dark ? "dark" : "light" });
  const complaints = complaintsOf(page);
  await page.addInitScript(hearResizes);
  if (prepare) await page.addInitScript(prepare);
  if (changed || changedData) {
    const text = readFileSync(file, "utf8"), body = changed ? exchanged(text, changed) : repacked(text, "data", exchanged(unpackedFrom(text, "data"), changedData));
    await page.route("file://**/index.html", (route) => route.fulfill({ contentType: "text/html", body }));
  }
  await page.goto(`file://${file}${address}`);
  await page.locator("main:not([aria-busy])").waitFor({ state: "attached" });
  await page.waitForFunction(() => {
    const section = document.getElementById(location.hash.slice(1).split("?")[0]);
    return section === null || section.hidden || section.querySelector(".waiting") === null;
  });
  return { page, complaints };
}

async function visited({ page, complaints }, visit) {
  await visit(page).catch((error) => {
    error.message = [error.message, ...complaints].join("\n");
    throw error;
  });
  assert.deepEqual(complaints, []);
}

// Has every section drawn, as print does, and waits for the charts.
export async function drawAll(page) {
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await settled(page);
}

// A picture of what may be higher than the window, which is as high as that for a moment. Nobody tells the page, which would draw charts
// again. Of the listeners of a window the first one that is added is called first.
const hearResizes = () => addEventListener("resize", (event) => globalThis.isPictured && event.stopImmediatePropagation());

export async function screenshot(locator, path) {
  const page = locator.page(), window = page.viewportSize();
  const resize = async (height) => {
    await page.setViewportSize({ ...window, height });
    await page.waitForFunction((wanted) => innerHeight === wanted, height);
  };
  const picture = (now) => page.evaluate((is) => new Promise((done) => requestAnimationFrame(() => done(globalThis.isPictured = is))), now);
  await picture(true);
  await resize(Math.max(window.height, Math.ceil((await locator.boundingBox()).height) + 1));
  await locator.screenshot({ path });
  await resize(window.height);
  await picture(false);
}

// The scene that the address leads to is drawn, and all charts that were begun are there, as wide as their places.
export async function settled(page) {
  await page.waitForFunction(() => {
    const [id] = decodeURIComponent(location.hash.slice(1)).split("?");
    const begun = (section) => section === null || section.querySelector("figure[data-chart] .chart") !== null;
    const charts = [...document.querySelectorAll("figure[data-chart] .chart")];
    return (!/^(scene|curve)-/.test(id) || begun(document.getElementById(id))) && charts.every((chart) => chart.querySelector("svg .role-mark path"));
  }, null, { timeout: patience });
}
