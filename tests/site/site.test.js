// SPDX-License-Identifier: MIT
// The site, opened from the disk.
import assert from "node:assert/strict";
import { join } from "node:path";
import { describe, test } from "node:test";
import { violations } from "../browser/accessible.js";
import { SCREENSHOTS, withPage as withPageOf } from "../browser/browser.js";

const { SITE } = process.env;
const pages = ["index", "docs/tutorial", "docs/schemes", "api/python", "map", "reference/data/index"];
// A page loads all words of the site for its search and sorts them, which takes more time than all else: a page that is not searched has none.
const withoutWords = () => {
  document.write = () => { globalThis.__search = { index: new Promise(() => {}), worker: URL.createObjectURL(new Blob()) }; };
};
// Pages of the site store the colours that a reader chose.
const withSearch = (how, visit) => withPageOf({ ...how, apart: true }, visit);
const withPage = (how, visit) => withSearch({ ...how, prepare: withoutWords }, visit);
const sizes = { 1280: 900, 390: 844 };

// Frames scroll what is wider than they are.
const widerThanTheWindow = (page) =>
  page.evaluate(() => [...document.querySelectorAll("body *")]
    .filter((node) => node.getBoundingClientRect().right > innerWidth + 1
      && !node.closest(".md-typeset__scrollwrap, pre, .highlight, .md-sidebar, .md-search, .md-tabs, svg"))
    .map((node) => `${node.tagName} ${node.className}: ${node.textContent.slice(0, 40)}`).slice(0, 5));

describe("the site", { concurrency: 2 }, () => {
  for (const [k, page] of pages.entries())
    for (const dark of [false, true])
      test(`${page} fits, and everyone can read it: ${dark ? "dark" : "light"}`, () =>
        withPage({ page: join(SITE, `${page}.html`), dark }, async (view) => {
          for (const [width, height] of Object.entries(sizes)) {
            await view.setViewportSize({ width: Number(width), height });
            await view.waitForFunction((wanted) => innerWidth === wanted, Number(width));
            assert.equal(await view.evaluate(() => document.documentElement.scrollWidth), Number(width));
            assert.deepEqual(await widerThanTheWindow(view), [], `at ${width} pixels`);
            await view.screenshot({ path: join(SCREENSHOTS, `${page.replaceAll("/", "_")}_${width}_${dark ? "dark" : "light"}.png`) });
          }
          assert.equal(await view.evaluate(() => document.body.dataset.mdColorScheme), dark ? "slate" : "default");
          if (dark === Boolean(k % 2)) assert.deepEqual(await violations(view, { excluded: [["iframe"]] }), []); // takes seconds
        }));

  test("no page is wider than a phone", () =>
    withPage({ page: join(SITE, "index.html"), width: 390 }, async (view) => {
      const links = await view.locator(".md-nav--primary a.md-nav__link").evaluateAll((nodes) => nodes.map(({ href }) => href.replace(/#.*/, "")));
      assert.ok(links.length > 20);
      for (const link of new Set(links)) {
        await view.goto(link);
        assert.equal(await view.evaluate(() => document.documentElement.scrollWidth), 390, link);
      }
    }));

  for (const width of [1280, 390])
    test(`the search finds Mittag-Leffler and leads there: ${width} pixels`, () =>
      withSearch({ page: join(SITE, "docs/tutorial.html"), width }, async (view) => {
        if (width < 600) await view.locator("label[for=__search].md-header__button").click();
        const query = view.locator("input[name=query]");
        const found = view.locator(".md-search-result__link", { hasText: "Mittag-Leffler functions" }).first();
        const isFound = () => found.waitFor({ timeout: 5000 }).then(() => true, () => false);
        for (let attempt = 1, is = false; !is; ++attempt) { // what is typed before the page listens to its field is lost
          assert.ok(attempt <= 10, "the search finds nothing");
          await query.fill("");
          await query.fill("Mittag-Leffler");
          is = await isFound();
        }
        await view.screenshot({ path: join(SCREENSHOTS, `search_${width}.png`) });
        await found.click();
        await view.waitForURL(/special_functions/);
      }));

  test("a switch changes the colours", () =>
    withPage({ page: join(SITE, "index.html") }, async (view) => {
      await view.locator("label.md-header__button[title='Dark colours']").click();
      assert.equal(await view.evaluate(() => document.body.dataset.mdColorScheme), "slate");
    }));

  test("the map opens", () =>
    withPage({ page: join(SITE, "map.html"), width: 390 }, async (view) => {
      await view.getByRole("link", { name: "Open the map" }).click();
      await view.waitForURL(/map\/index\.html/);
      await view.waitForFunction(() => /pendulum/i.test(document.body.innerText));
    }));
});
