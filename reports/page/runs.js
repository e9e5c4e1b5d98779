// SPDX-License-Identifier: MIT
// Runs arrive as columns, and are shown as points that know all that is known of them.

// A row for each run, { line, steps, ... }, without what it does not have.
function rowsOf({ lines, end, ...columns }) {
  const names = Object.keys(columns);
  return columns.steps.map((_, i) => {
    const row = Object.fromEntries(names.filter((name) => columns[name][i] !== null).map((name) => [name, columns[name][i]]));
    return { ...row, ...(end !== undefined && { h: end / row.steps }), line: lines[row.line] };
  });
}

// The slope between a run and the next coarser one of its line.
function rateBetween(coarse, fine, error) {
  if (!(coarse?.[error] > 0) || !(fine[error] > 0) || coarse.line !== fine.line || fine.requested || coarse.h === fine.h) return undefined;
  return Math.log(coarse[error] / fine[error]) / Math.log(coarse.h / fine.h);
}

// What a point's tooltip says, a name and a text each.
function wordsOf(row, coarser, kind, kinds, { parameter, made }) {
  const words = { title: row.line };
  const add = (name, value, text) => {
    if (value !== undefined) words[name] = text(value);
  };
  const time = (seconds) => timeText(seconds) + (row.wall_clock ? " of the wall clock" : "");
  if (parameter) add(parameter, row.value, String);
  add("requested", row.requested, fewDigits);
  add("N", row.steps, String);
  add("h", row.h, (h) => String(Number(h.toPrecision(3))));
  add("grid", row.grading, (grading) => `graded:${Number(grading.toPrecision(3))}`);
  add("time", row.time_minimum, time);
  add("median time", row.time_median, time);
  add(`rate from N = ${coarser?.steps}`, rateBetween(coarser, row, kind.id), (rate) => rate.toFixed(2));
  for (const of of kinds) add(titleOfKind(of), row[of.id], fewDigits);
  add("bound of the reference", row.reference_bound_maximum, fewDigits);
  add("rounding", row.rounding, fewDigits);
  add("energy residual", row.energy_residual, fewDigits);
  add("internal drift", row.drift_internal, fewDigits);
  add("independent drift", row.drift_independent, fewDigits);
  add("calls of f", row.rhs_calls, String);
  add("Newton iterations", row.newton_iterations, String);
  add("rejected steps", row.rejected_steps, String);
  add("memory of the history", row.history_bytes, bytesText);
  for (const [name, value] of Object.entries(row)) if (name.startsWith("own ")) add(name.slice(4), value, fewDigits);
  return { ...words, ...made?.[(row.session ?? 1) - 1] };
}

// The points of a section for a kind of error.
function pointsOf(section, kind, kinds) {
  const rows = rowsOf(section.runs);
  return rows.map((row, i) => ({
    ...row, rank: row.requested ? -row.requested : row.steps, error: row[kind.id], ratio: row[kind.id] / row.requested,
    words: wordsOf(row, section.parameter ? undefined : rows[i - 1], kind, kinds, section),
  }));
}

// Lines of theoretical slope, each from a line's finest point to its coarsest step.
function guidesOf(points, rates, { norm }) {
  return rates.filter((rate) => rate[norm] !== undefined).flatMap((rate) => {
    const line = points.filter((point) => point.line === rate.line);
    const [coarsest, finest] = [line[0], line.at(-1)];
    if (!(finest?.error > 0)) return [];
    return [finest.h, coarsest.h].map((h) => ({ line: rate.line, h, error: finest.error * (h / finest.h) ** rate[norm] }));
  });
}
