// SPDX-License-Identifier: MIT
// A family of scenes: its sentence at the top, its map over the chosen axes, the dialog of a cell, the robustness of the schemes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { violations } from "./accessible.js";
import { PAGE, screenshot, SCREENSHOTS, settled, withPage } from "./browser.js";
import { finished, runsOf, scenesOf } from "./records.js";

const folder = (name) => join(dirname(PAGE), name);
const page_of_family = folder("family/index.html"), results = folder("family.jsonl");
const runs = runsOf(results), scenes = scenesOf(runs);
const within = (scene, accuracy) => finished(runs).filter((run) => run.scene === scene && run.error_maximum_mixed <= accuracy && run.time_median)
  .sort((a, b) => a.time_median - b.time_median);
const family = { page: page_of_family, address: "#family-power" };
const drawn = async (page) => {
  await page.locator('[id="family-power"] figure[data-chart="winners"] svg .role-mark path').first().waitFor();
  await settled(page);
};
const cellsOf = (page) => page.evaluate(() => cellsOfPlane(data.sections.find(({ plane }) => plane), chosenKind(data.kinds), viewNow(), data.sections.find(({ plane }) => plane).chosen).map(winnerOf));
const choose = (page, name, label) => page.locator(`.plane [name="${name}"]`).selectOption({ label });

test("a family has one section, a sentence at the top and no section of a scene", () =>
  withPage({ page: page_of_family }, async (page) => {
    assert.deepEqual(await page.locator('section[id^="scene-"]').count(), 0);
    const said = await page.locator("#answer .conclusion").textContent();
    assert.match(said, new RegExp(`^Over gamma and p of A power of time \\(${scenes.length} scenes, mixed maximum error to 1e-\\d+\\) the cheapest is \\w+ in \\d+`));
    assert.match(said, /Without knowing them take \w+: in 95\u202f% of the scenes that some scheme solves it takes at most|none solves 95\u202f% of the scenes/);
    await page.locator("#answer .conclusion a").click();
    await drawn(page);
    assert.equal(new URL(page.url()).hash, "#family-power");
  }));

test("each cell of the map has the cheapest run of the records, to each accuracy", () =>
  withPage({ ...family, address: "#family-power?accuracy=1e-2" }, async (page) => {
    await drawn(page);
    for (const accuracy of ["1e-2", "1e-4", "1e-12"]) {
      await page.selectOption("#accuracy", accuracy);
      const cells = await cellsOf(page);
      assert.equal(cells.length, scenes.length);
      for (const { scenes: [{ scene, line, steps, second, ties }] } of cells) {
        const [first, ...others] = within(scene, Number(accuracy));
        const next = others.find(({ scheme }) => scheme !== first.scheme);
        assert.deepEqual([line, steps, second?.line], [first?.scheme, first?.steps, next?.scheme], scene);
        assert.equal(ties?.includes(next.scheme) ?? false, Boolean(next) && next.time_low <= first.time_high, scene);
      }
    }
    await settled(page);
    assert.equal(await page.locator('[id="family-power"] .mark-text.role-mark text').count(), scenes.filter((scene) => within(scene, 1e-12).length === 0).length, "crosses");
  }));

test("the reader chooses the axes, a slice or the most frequent winner", () =>
  withPage(family, async (page) => {
    await drawn(page);
    await choose(page, "across", "p");
    assert.equal(await page.locator('.plane [name="up"] option:checked').textContent(), "gamma", "axes are exchanged");
    assert.equal(await page.evaluate(() => document.activeElement.name), "across");
    await choose(page, "up", "accuracy");
    await drawn(page);
    const cells = await cellsOf(page);
    assert.equal(cells.length, 5 * 6);
    assert.ok(cells.every(({ scenes: of }) => of.length === 4));
    for (const { scenes: of, line, share } of cells.filter((cell) => cell.line)) assert.equal(share, of.filter((one) => one.line === line).length / 4);
    await choose(page, "fixed-0", "0.4");
    await drawn(page);
    assert.deepEqual((await cellsOf(page)).map(({ scenes: of }) => of.length), Array(30).fill(1));
    assert.match(await page.locator('[id="family-power"] figcaption').first().textContent(), /over p and accuracy$/);
  }));

test("a cell's dialog has the command that repeats it, by the mouse and by the keyboard", () =>
  withPage({ ...family, address: "#family-power?accuracy=1e-2" }, async (page) => {
    await drawn(page);
    await page.locator('[id="family-power"] .mark-symbol.role-mark path').first().click();
    const command = await page.locator("#cell .command code").textContent();
    assert.match(command, /^fdebench solve power:gamma=[\d.]+,p=[\d.]+ --scheme \w+ --steps \d+$/);
    assert.match(execFileSync(process.env.PROGRAM, command.split(" ").slice(1), { encoding: "utf8" }), /^t,y\n/);
    await page.keyboard.press("Escape");
    await page.locator('[id="family-power"] .numbers summary').first().click();
    const button = page.locator('[id="family-power"] .numbers tbody button').first();
    await button.focus();
    await page.keyboard.press("Enter");
    assert.ok(await page.locator("#cell").isVisible());
    assert.match(await page.locator("#cell h2").textContent(), /^power:gamma=/);
  }));

test("the table has what robustness is of the records", () =>
  withPage({ ...family, address: "#family-power?accuracy=1e-2" }, async (page) => {
    await drawn(page);
    const solved = scenes.filter((scene) => within(scene, 1e-2).length > 0);
    const regret = (scene, scheme) => (within(scene, 1e-2).find((run) => run.scheme === scheme)?.time_median ?? Infinity) / within(scene, 1e-2)[0].time_median;
    const rows = await page.locator('[id="family-power"] > details > div > .frame tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.firstChild?.nextSibling?.textContent && cell.querySelector(".swatch") ? cell.textContent : cell.firstChild?.textContent)));
    assert.ok(rows.length > 0);
    for (const [scheme, of, , near] of rows) {
      const name = scheme.replace(/\s.*/s, ""), count = solved.filter((scene) => regret(scene, name) < Infinity).length;
      assert.equal(of, `${count} of ${solved.length}`, name);
      assert.equal(near, `${Math.round((100 * solved.filter((scene) => regret(scene, name) <= 1.2).length) / solved.length)}\u202f%`, name);
    }
  }));

for (const [width, height, dark] of [[1280, 900, true], [390, 844, false], [1280, 900, false], [390, 844, true]]) {
  test(`a family fits and can be read at ${width} pixels, ${dark ? "dark" : "light"}`, () =>
    withPage({ ...family, width, height, dark }, async (page) => {
      await drawn(page);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      assert.deepEqual(await violations(page, { away: "svg.marks > g" }), []);
      await screenshot(page.locator('[id="family-power"]'), join(SCREENSHOTS, `family_${width}_${dark ? "dark" : "light"}.png`));
    }));
}

test("a choice of other schemes leaves their cells faint", () =>
  withPage({ ...family, address: "#family-power?schemes=l1&accuracy=1e-2" }, async (page) => {
    await drawn(page);
    assert.match(await page.getByRole("status").textContent(), /1 of \d+ schemes/);
    const opacities = await page.locator('[id="family-power"] .mark-symbol.role-mark path').evaluateAll((marks) => marks.map((mark) => [mark.__data__.datum.line, Number(mark.getAttribute("opacity") ?? 1)]));
    for (const [line, opacity] of opacities) assert.equal(opacity < 0.5, line !== "l1", line);
  }));

test("hostile names of schemes, parameters and scenes are names like others", async () => {
  const file = folder("family_hostile.jsonl"), names = { l1: "constructor", bdf2: "__proto__" };
  const lines = readFileSync(results, "utf8").trim().split("\n").map((line) => JSON.parse(line));
  for (const line of lines) {
    const row = line.scene?.scene ? line.scene : line;
    if (row.scheme) row.scheme = names[row.scheme] ?? row.scheme;
    if (row.scene) row.scene = "<b>x</b> 'y'";
    if (row.settings) row.settings = Object.fromEntries([["accuracy", row.settings.gamma], ["toString", row.settings.p ?? 2]]);
    delete row.parameters;
  }
  writeFileSync(file, lines.filter((line) => !line.scene?.scene).map((line) => `${JSON.stringify(line)}\n`).join(""));
  execFileSync(process.env.PROGRAM, ["report", file, "--out", folder("family_hostile")]);
  await withPage({ page: folder("family_hostile/index.html") }, async (page) => {
    const section = page.locator('section[id^="family-"]');
    await section.scrollIntoViewIfNeeded();
    await section.locator("figure svg .role-mark path").first().waitFor();
    assert.equal(await page.locator("main b").count(), 0);
    assert.doesNotMatch(await page.locator("main").textContent(), /undefined|native code|\[object|NaN/);
    await choose(page, "up", "toString");
    await section.locator("figure svg .role-mark path").first().waitFor();
    assert.match(await section.locator("figcaption").first().textContent(), /over accuracy and toString/);
    assert.ok((await section.locator("table").last().textContent()).includes("constructor"));
  });
});
