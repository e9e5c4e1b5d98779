// SPDX-License-Identifier: MIT
// Colours of lines and verdicts as readers with colour blindness see them, and the second channel that tells lines apart.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { RESULTS, withPage, withReadPage } from "./browser.js";
import { finished, runsOf } from "./records.js";

const { PROGRAM } = process.env;

const linear = (byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
const colourOf = (hex) => [1, 3, 5].map((place) => linear(parseInt(hex.slice(place, place + 2), 16)));

// Machado, Oliveira & Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009), severity 1.
const blindness = {
  none: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const seen = (matrix, rgb) => matrix.map((row) => Math.min(1, Math.max(0, row.reduce((sum, weight, i) => sum + weight * rgb[i], 0))));

// CIE L*a*b* under D65; a distance of 2.3 is just noticeable.
function lab([r, g, b]) {
  const f = (t) => (t > (6 / 29) ** 3 ? Math.cbrt(t) : t / (3 * (6 / 29) ** 2) + 4 / 29);
  const [x, y, z] = [[0.4124, 0.3576, 0.1805, 0.9505], [0.2126, 0.7152, 0.0722, 1], [0.0193, 0.1192, 0.9505, 1.089]].map(([p, q, s, white]) => f((p * r + q * g + s * b) / white));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const distance = (a, b) => Math.hypot(...lab(a).map((value, i) => value - lab(b)[i]));

function nearest(all, matrix) {
  const pairs = all.flatMap((a, i) => all.slice(i + 1).map((b) => ({ a, b, distance: distance(...[a, b].map((hex) => seen(matrix, colourOf(hex)))) })));
  return pairs.reduce((least, pair) => (pair.distance < least.distance ? pair : least));
}

for (const dark of [false, true]) {
  test(`colours are distinguished by the colour-blind: ${dark ? "dark" : "light"}`, () =>
    withPage({ dark, address: "#?scene=none" }, async (page) => {
      const all = await page.evaluate(() => colours);
      assert.equal(new Set(all).size, all.length);
      for (const [kind, matrix] of Object.entries(blindness)) {
        const { a, b, distance: least } = nearest(all, matrix);
        assert.ok(least > 8, `${kind}: ${a} and ${b} are ${least.toFixed(1)} apart`);
      }
    }));
}

test("every scheme has a mark of its own, whatever else is drawn, and another one on another grid", () =>
  withReadPage("", async (page) => {
    const ids = JSON.parse(execFileSync(PROGRAM, ["schemes", "--json"], { encoding: "utf8" })).map(({ id }) => id);
    const marksOf = (lines, of) => page.evaluate(([all, some]) => some.map((line) => `${colourOf(all, line)} ${shapeOf(all, line)}`), [lines, of]);
    assert.deepEqual(await page.evaluate((all) => all.filter((id) => placeOfMark(id) < 0), ids), [], "schemes without a place of their mark");
    const alone = (await Promise.all(ids.map((id) => marksOf([id], [id])))).flat();
    const others = ids.flatMap((id) => [`${id}, graded`, id, `${id}, direct`]).slice(0, 60);
    assert.equal(new Set(alone).size, ids.length);
    assert.deepEqual(await marksOf([...ids].reverse(), ids), alone);
    assert.deepEqual(await marksOf(["mine", "yours, graded", ...others, ...ids], ids), alone);
    const graded = (await marksOf(others, others)).map((mark, i) => [others[i], mark]);
    assert.equal(new Set(graded.map(([, mark]) => mark)).size, others.length);
    assert.equal(graded[0][1].split(" ")[0], alone[0].split(" ")[0]);
  }));

test("no two lines have colour and shape in common", () =>
  withReadPage("", async (page) => {
    const many = Array.from({ length: 60 }, (_, i) => `line_${i}`);
    const marks = await page.evaluate((lines) => lines.map((line) => `${colourOf(lines, line)} ${shapeOf(lines, line)}`), many);
    assert.equal(new Set(marks).size, many.length);
    const winner = finished(runsOf(RESULTS)).length > 0 && await page.evaluate(() => data.lines[0]);
    assert.equal(await page.locator("#winners dt").first().evaluate((node) => node.lastChild.textContent), winner);
  }));
