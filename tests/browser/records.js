// SPDX-License-Identifier: MIT
// What the results file says should be on the page, read without the report.
import { readFileSync } from "node:fs";

const labelOf = (scene, settings = {}) =>
  [scene, Object.entries(settings).map(([name, value]) => `${name}=${value}`).join(",")].filter(Boolean).join(":");

// A trial has as many steps as no other run of these results.
const trialSteps = 4096;

// Each run once: {scene, scheme, steps, requested, ending, <measure>: value, ...}.
export function runsOf(file) {
  const runs = new Map();
  for (const line of readFileSync(file, "utf8").trim().split("\n")) {
    const { session, scene, settings, scheme, steps, accuracy, end, ending, values, time } = JSON.parse(line);
    if (session || typeof scene !== "string") continue;
    const label = labelOf(scene, settings);
    const key = JSON.stringify([label, scheme, accuracy ?? steps]);
    if (ending) runs.set(key, { scene: label, scheme, steps, h: end / steps, requested: accuracy?.relative, ending });
    Object.assign(runs.get(key), values, time);
  }
  return [...runs.values()];
}

export const isTrial = (run) => run.steps === trialSteps;
export const finished = (runs) => runs.filter((run) => run.ending === "finished" && !isTrial(run));
export const scenesOf = (runs) => [...new Set(finished(runs).map(({ scene }) => scene))];

// As the page writes them.
export const errorText = (value) => value.toExponential(1).replace("e+", "e");

// The runs that each chart of a scene draws, by the quantity of the error that is shown.
export const drawn = {
  "error-against-time": (runs, error) => runs.filter((run) => run[error] > 0 && run.time_minimum > 0),
  "error-against-memory": (runs, error) => runs.filter((run) => run[error] > 0 && run.history_bytes > 0),
  "error-against-step": (runs, error) => runs.filter((run) => run[error] > 0 && !run.requested),
  "delivered-against-requested": (runs, error) => runs.filter((run) => run[error] > 0 && run.requested),
  "energy-against-step": (runs) => runs.filter((run) => run.energy_residual > 0 && !run.requested),
};
