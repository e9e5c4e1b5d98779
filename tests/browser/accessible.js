// SPDX-License-Identifier: MIT
// What axe-core finds on a page.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

// Takes what the selector finds out of the page, and puts it back.
const takeAway = (selector) => {
  globalThis.taken = [...document.querySelectorAll(selector)].map((node) => [node, node.parentNode, node.nextSibling]);
  for (const [node] of taken) node.remove();
};
const putBack = () => {
  for (const [node, parent, next] of taken.reverse()) parent.insertBefore(node, next);
};

// What it calls serious or critical: labels, contrast, roles, what a keyboard reaches. Without the parts that the selectors name: axe passes
// over those that are excluded, and takes time for each of their elements; what is taken away is not there for it.
export async function violations(page, { excluded = [], away }) {
  await page.evaluate(axe);
  if (away) await page.evaluate(takeAway, away);
  const found = await page.evaluate((exclude) => globalThis.axe.run({ exclude }, { resultTypes: ["violations"], preload: false }), excluded);
  if (away) await page.evaluate(putBack);
  return found.violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.length} times, ${nodes[0].target} ${nodes[0].failureSummary}`);
}
