// SPDX-License-Identifier: MIT
// What axe-core finds on a page.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

// What it calls serious or critical: labels, contrast, roles, what a keyboard reaches. Without the parts that the selectors name.
export async function violations(page, excluded) {
  await page.evaluate(axe);
  const found = await page.evaluate((exclude) => globalThis.axe.run({ exclude }, { resultTypes: ["violations"], preload: false }), excluded);
  return found.violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.length} times, ${nodes[0].target} ${nodes[0].failureSummary}`);
}
