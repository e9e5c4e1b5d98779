// SPDX-License-Identifier: MIT
// What a reader with a phone has, and what each recommendation gives: names in full, a command to copy.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { PAGE, settled, withPage, withReadPage } from "./browser.js";
import { sectionOf } from "./charts.js";

const { PROGRAM } = process.env;
const phone = { width: 390, height: 844 };
const machine = "a machine whose name is much longer than a telephone is wide, as those of processors are";

test("a page with long names of machines and scenes is as wide as a phone", () =>
  withPage({ width: 390, page: join(dirname(PAGE), "machines", "index.html"), changedData: [JSON.stringify("an older machine"), JSON.stringify(machine)] }, async (page) => {
    await page.locator("#machine").waitFor();
    await page.evaluate((of) => {
      document.querySelector("#machine").append(Object.assign(document.createElement("option"), { textContent: of }));
      for (const code of document.querySelectorAll("h2 code")) code.textContent = `linear_system:${"gamma1=0.7089,".repeat(12)}`;
    }, machine);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  }));

test("a phone shows the answer, and the other sections when they are opened", () =>
  withPage(phone, async (page) => {
    const open = () => page.locator("main > section > details[open]").evaluateAll((all) => all.map((of) => of.parentNode.id));
    assert.deepEqual(await open(), ["answer"]);
    assert.equal(await page.locator("figure[data-chart]").count(), 0);
    await sectionOf(page, "pendulum").locator("summary").first().click();
    await sectionOf(page, "pendulum").locator("figure[data-chart] svg").first().waitFor();
    await page.evaluate(() => { location.hash = "#stability"; });
    await page.locator("#stability td[data-tone]").first().waitFor();
    assert.deepEqual(await open(), ["answer", "stability", "scene-pendulum"]);
    await sectionOf(page, "pendulum").locator("summary").first().click();
    await sectionOf(page, "pendulum").locator("figure[data-chart]").first().waitFor({ state: "hidden" });
  }));

// The command's answer, of two times. A run with an accuracy chooses its steps, which --points would limit.
function answerOf(command) {
  const [program, ...words] = command.split(" ");
  assert.equal(program, "fdebench");
  return promisify(execFile)(PROGRAM, [...words, ...(words.includes("--accuracy") ? [] : ["--points", "2"])])
    .then((answer) => ({ ...answer, status: 0 }), (refused) => ({ ...refused, status: refused.code }));
}

// What the dialog of a cell shows once its button is pressed.
const tapped = (button) => button.evaluate((node) => {
  node.click();
  const dialog = document.getElementById("cell"), texts = (list) => [...list.querySelectorAll("dt")].map((name) => [name.textContent, name.nextElementSibling.textContent]);
  return {
    label: node.getAttribute("aria-label"), title: dialog.querySelector("h2").textContent, name: dialog.querySelector(".name")?.textContent,
    command: dialog.querySelector(".command code")?.textContent, right: dialog.getBoundingClientRect().right, facts: Object.fromEntries(texts(dialog.querySelector("dl"))),
  };
});

// Every cell of a map by its button: [cell, what its dialog shows, the answer of its command].
async function openEach(page, map) {
  const cells = await page.locator(`${map} .map td button`).all(), opened = [], answers = new Map();
  for (const button of cells) {
    const shown = await tapped(button);
    if (shown.command && !answers.has(shown.command)) answers.set(shown.command, await answerOf(shown.command));
    opened.push({ ...shown, answer: answers.get(shown.command) });
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#cell").isVisible(), false);
  }
  return opened;
}

test("a tap on a cell of the map shows the scheme in full, its numbers and a command that runs", () =>
  withReadPage("", async (page) => {
    const lines = await page.evaluate(() => data.lines), opened = await openEach(page, "#answer");
    assert.equal(opened.length, await page.locator("#answer .map td").count());
    for (const { label, title, name, facts: shown, command, answer, right } of opened) {
      assert.ok(title.length > 0 && right <= 390, label);
      assert.ok(lines.includes(shown["the best"] ?? name), `${label}: ${name}`);
      for (const number of ["N", "error", "time"]) assert.match(shown[number], /\d/, `${label}: ${number}`);
      assert.equal(answer.status, 0, `${command}: ${answer.stderr}`);
      assert.match(answer.stdout, /^t,/, command);
      if (command.includes("--steps")) assert.equal(shown.N.replaceAll("\u202f", ""), /--steps (\d+)/.exec(command)[1]);
    }
  }, phone));

test("a tap on a trial shows its verdict with the reason and a command, which ends as the verdict says", () =>
  withReadPage("#stability", async (page) => {
    await page.locator("#stability td[data-tone]").first().waitFor();
    const opened = await openEach(page, "#stability");
    assert.equal(opened.length, await page.locator("#stability .map td:not(:empty)").count());
    for (const { label, name, facts: { verdict, survives }, command, answer } of opened) {
      assert.ok(name && (verdict || survives), label);
      assert.equal(Boolean(verdict), Boolean(command), label);
      if (/^(survives|inaccurate)$/.test(verdict)) assert.equal(answer.status, 0, `${command}: ${answer.stderr}`);
      if (/^refuses/.test(verdict)) assert.ok(answer.stderr.includes(verdict.replace("refuses: ", "")), `${command}: ${answer.stderr}`);
    }
  }, phone));

test("a cell is opened, copied and closed by the keyboard, and the focus returns to it", () =>
  withPage(phone, async (page) => {
    await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: (of) => { globalThis.copied = of; return Promise.resolve(); } } }));
    const cell = page.locator("#answer .map td button").first(), dialog = page.getByRole("dialog");
    await cell.focus();
    await page.keyboard.press("Enter");
    assert.equal(await dialog.getAttribute("aria-labelledby"), await dialog.locator("h2").getAttribute("id"));
    await page.keyboard.press("Enter");  // the first control copies
    await dialog.getByText("Copied").waitFor();
    assert.match(await page.evaluate(() => globalThis.copied), /^fdebench solve /);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "Go to this scene");
    await page.keyboard.press("Escape");
    assert.equal(await dialog.count(), 0);
    assert.ok(await cell.evaluate((node) => node === document.activeElement));
    await cell.click();
    await page.mouse.click(195, 20);  // beside it
    assert.equal(await dialog.count(), 0);
  }));

test("each recommendation is a command that runs, and a button copies it", () =>
  withPage({ address: "#scene-pendulum?scene=pendulum" }, async (page) => {
    await settled(page);
    const rows = sectionOf(page, "pendulum").locator(":scope > details > div > .frame tbody tr", { has: page.locator(".swatch") });
    assert.ok(await rows.count() > 2);
    assert.equal(await rows.locator(".command").count(), await rows.count());
    const row = rows.first(), text = await row.locator(".command code").textContent();
    const steps = /N = (\d+)/.exec(await row.textContent())[1];
    assert.match(text, /^fdebench solve pendulum --scheme \w+ --(steps|accuracy) /);
    assert.match((await answerOf(text)).stdout, /^t,phi,/);
    if (text.includes("--steps")) assert.ok(text.includes(`--steps ${steps}`));
    await page.evaluate(() => { document.addEventListener("copy", () => { globalThis.copied = getSelection().toString(); });
      Object.defineProperty(navigator, "clipboard", { value: { writeText: (of) => { globalThis.copied = of; return Promise.resolve(); } } }); });
    await row.locator(".command button").click();
    assert.equal(await page.evaluate(() => globalThis.copied), text);
    assert.equal(await row.locator(".command button").textContent(), "Copied");
  }));

test("what is said of schemes, trials and references follow the filters", () =>
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
  }));

test("trials are of the schemes that are wanted", () =>
  withPage({ address: "#stability?schemes=l1,bdf4" }, async (page) => {
    await settled(page);
    assert.deepEqual((await page.locator("#stability thead tr").last().locator("th").allTextContents()).slice(1).sort(), ["bdf4", "l1"]);
  }));
