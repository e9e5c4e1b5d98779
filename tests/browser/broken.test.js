// SPDX-License-Identifier: MIT
// The checks of this folder see what is broken: each of these pages has one fault.
import assert from "node:assert/strict";
import { test } from "node:test";
import { RESULTS, settled, withPage } from "./browser.js";
import { checkCharts } from "./charts.js";
import { runsOf } from "./records.js";

const faults = {
  "a chart that drops a point": [/error-against-time: points/, "point.error && point[field]", "point.error && point[field] && point.steps !== 256"],
  "a chart that draws another number": [/no point of/, "error: row[kind.id]", "error: 2 * row[kind.id]"],
  "a chart whose points cannot be seen": [/cannot be seen/, "filled: true, size: 45", "filled: true, size: 0"],
  "a chart that is left out": [/error-against-time$/m, "const chartsOfScenes = [errorAgainstTime, ", "const chartsOfScenes = ["],
  "a chart that throws": [/unheard/, "title: `Error against ${name}; band", "title: unheard.of + `"],
};

for (const [fault, [complaint, before, after]] of Object.entries(faults)) {
  test(`${fault} is seen`, () =>
    assert.rejects(withPage({ changed: [before, after], address: "#scene-pendulum?scene=pendulum" }, async (page) => {
      await settled(page);
      await checkCharts(page, runsOf(RESULTS), "error_maximum_mixed", ["pendulum"]);
    }), complaint));
}
