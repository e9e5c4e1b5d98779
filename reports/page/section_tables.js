// SPDX-License-Identifier: MIT
// The tables of the page by the ids of their sections (fact_tables.js). A column has a heading, perhaps one that it shares with its
// neighbours (over), and templates of what its cells say of a row: the text, a smaller second line (detail), the line whose colour they
// have, whether they are marked, a hint, the section that they lead to, a command. `opened` is what a map's cell shows when it is chosen
// (cell_dialog.js), where it has one of the facts `of`. `each` is a list of the section: a column for every
// element, with the facts of the row's `cells`. In a map cells have the colours of their lines or verdicts. `filter` is the fact with the
// lines of a row, which a choice of schemes is about. `fades`: the cells, or the rows, of lines that are not wanted are faint.

const lineColumn = { head: "scheme", cell: "{line}", detail: "{grid}", line: "{line}" };
const titleColumn = { head: "scene", cell: "{title}", detail: "{name}" };

const rateColumns = (over, norm) => [
  { head: "theory", over, cell: `{${norm}.expected:hundredths}` },
  {
    head: "observed", over, cell: [`{${norm}.observed:hundredths}`, "no fit"], marked: [`{${norm}.above}`, `{${norm}.below}`],
    detail: [`{${norm}.above:hundredths} above theory`, `{${norm}.below:hundredths} below theory`, `{!${norm}.observed}fewer than three errors above rounding`],
  },
  { head: "correlation", over, cell: `{${norm}.correlation:correlation}` },
];
const driftColumns = (over, rule) => [
  { head: "largest", over, cell: `{${rule}.largest:error}` },
  { head: "growth", over, cell: `{${rule}.growth:hundredths}` },
  { head: "rate in h", over, cell: `{${rule}.rate:hundredths}`, detail: `correlation {${rule}.correlation:correlation}` },
];
const referenceColumns = (over, norm) => [
  { head: "reference", over, cell: `{${norm}.bound:error}` },
  { head: "smallest measured", over, cell: `{${norm}.error:error}`, detail: `{${norm}.line}, N = {${norm}.steps:count}`, line: `{${norm}.line}` },
  {
    head: "ratio", over, cell: [`{${norm}.ratio:error}`, `{?${norm}}the error is 0`], marked: `{${norm}.unresolved}`,
    detail: `{?${norm}.unresolved}not resolved by the reference`,
  },
];
const stateColumns = (over, scheme) => [
  { head: "states", over, cell: `{${scheme}.states:count}` },
  { head: "time", over, cell: `{?${scheme}.error_end}{${scheme}.time_minimum:time}`, detail: `{?${scheme}.time_minimum}error {${scheme}.error_end:error}` },
];

const repeated = ["fdebench solve {row.name:shell} --scheme {scheme} {options}", "fdebench solve {row.name:shell} --scheme {best.scheme} {best.options}"];
const openedAnswer = {
  of: ["line", "best"], title: "{row.title}", about: "{section.kind:kind} ≤ {each:power}", line: ["{line}", "{:cheapest}"], command: repeated,
  rows: [
    ["the same here as", "{same}"], ["the best", "{best.line}"], ["grid", ["{grid}", "{best.grid}"]],
    ["accuracy asked for", ["{requested:error}", "{best.requested:error}"]], ["N", ["{steps:count}", "{best.steps:count}"]],
    ["error", ["{error:error}", "{best.error:error}"]], ["time", ["{:timed}", "{best:timed}", "{?line}not timed"]],
    ["first run of a process", ["{first_seconds:time}", "{best.first_seconds:time}"]], ["later runs", ["{later_seconds:time}", "{best.later_seconds:time}"]],
    ["session", ["{session}", "{best.session}"]], ["why", "{:why}"],
  ],
};
const openedCode = {
  of: ["line", "best"], title: "{row.code}", about: "{section.kind:kind} ≤ {each:power}", line: ["{line}", "{best.line}"],
  rows: [
    ["language", "{row.language}"], ["N", ["{steps:count}", "{best.steps:count}"]], ["error", ["{error:error}", "{best.error:error}"]],
    ["time of a later solve", "{seconds:time}"], ["first solve of a process", "{first_seconds:time}"], ["start of the process", "{start_seconds:time}"],
    ["times that of fdebench", "{ratio:three}"],
  ],
};
const openedTrial = {
  of: ["verdict", "trials"], title: ["{row.scene}", "All trials"], about: ["{?verdict}{row.steps:count} steps"], line: "{each}", command: "fdebench solve {row.scene:shell} --scheme {scheme} {options}",
  rows: [
    ["verdict", "{verdict}[{!ending=refused}: {:ending}][{?ending=refused}: {detail}]"], ["error, as a part of the value", "{error:error}"], ["rounding from", "t = {rounding_from:three} on"],
    ["time", "{seconds:time}[{?wall_clock} of the wall clock]"], ["survives", "{survive} of {trials}"], ["stops rightly", "{stop}"], ["refuses", "{refused}"],
  ],
};

const openedMember = {
  of: ["line", "best"], title: ["{scene}", "{several} scenes"], about: "{kind:kind} ≤ {accuracy:power}", line: ["{line}", "{?several}most often no scheme gets there", "no scheme gets there"],
  command: "fdebench solve {scene:shell} --scheme {scheme} {options}",
  rows: [
    ["cheapest in", "{winners:wins_of/; }"], ["N", "{steps:count}"], ["error", "{error:error}"], ["time", "{seconds:time} ({low:time} ... {high:time})[{?wall_clock} of the wall clock]"],
    ["within noise", "{ties}"], ["second", "{second.line}, × {second.ratio:three}"], ["session", "{session}"], ["smallest error", "{best.error:error}, by {best.line}"],
  ],
};

const sectionTables = {
  answer: {
    caption: "The cheapest measured run by scene and {kind:kind}", map: true, fades: "cells",
    columns: [
      { head: "scene", cell: "{title}", to: "{id}" },
      {
        each: "accuracies", head: "≤ {each:power}", cell: "{line}", line: "{line}",
        detail: ["{?line}{seconds:time}", "{?untimed}not timed yet", "best {best.error:error}", "not measured"],
        hint: "{:cheapest}[: {:its_run}][: {:why}]", opened: openedAnswer,
      },
    ],
  },
  scene: {
    caption: "The cheapest measured run by {kind:kind}", fades: "rows",
    columns: [
      { head: "{kind:kind}", cell: "≤ {accuracy:power}" },
      { head: "cheapest", cell: "{:cheapest}", detail: "here the same as {same}", line: "{line}" },
      { head: "its run", cell: "{:its_run}", command: ["fdebench solve {section.name:shell} --scheme {scheme} {options}", "fdebench solve {section.name:shell} --scheme {best.scheme} {best.options}"] },
      { head: "why", cell: "{:why}" },
    ],
  },
  parameters: {
    caption: "Parameters",
    columns: [{ head: "parameter", cell: "{name}" }, { head: "value", cell: "{value}", marked: "{given}" }, { head: "meaning", cell: "{meaning}" }],
  },
  family: {
    caption: "How robust each scheme is, {kind:kind} to {accuracy:power}",
    columns: [
      lineColumn, { head: "scenes solved", cell: "{solved} of {scenes}" }, { head: "the cheapest, no tie", cell: "{won}" },
      { head: "within 20 % of the cheapest", cell: "{near.value:percent}", detail: "{near.low:percent} to {near.high:percent}" },
      ...[["median", "median"], ["95 % quantile", "tail"]].map(([head, of]) => ({ head, over: "regret", cell: [`{${of}.value:two}`, "∞"], detail: [`{${of}.low:two} to {${of}.high:two}`, `from {${of}.low:two} on`] })),
    ],
  },
  codes: {
    caption: "The time of each code's quickest run by {kind:kind}",
    columns: [
      { head: "code", cell: "{code}", detail: ["{:ending}", "[{version}, ]{language}"] },
      {
        each: "accuracies", head: "≤ {each:power}", cell: "{seconds:time}", detail: ["× {ratio:three}", "{line}", "best {best.error:error}"], opened: openedCode,
      },
    ],
  },
  compared: {
    caption: "Runs of both results that changed", filter: "line", group: "{change:changes}: {count}",
    columns: [
      { head: "scene", cell: "{scene}", to: "{to}" },
      { head: "scheme", cell: "{line}", detail: ["N = {steps:count}", "accuracy {requested:error}"], line: "{line}" },
      ...["first", "second"].map((head, i) => ({ head, cell: [`{verdicts.${i}:judged}`, `{errors.${i}:error}`, `{times.${i}:time}`] })),
      {
        head: "change", marked: "{worse}",
        cell: ["{?verdicts}[{?worse}worse][{!worse}changed]", "{quantity} [× {factor:three}][{!factor}from 0]", "× {ratio:three} ({low:three} to {high:three})"],
      },
    ],
  },
  stability: {
    caption: "Verdicts by scene and scheme", map: true,
    columns: [
      { head: "scene", cell: ["{scene}", "survived"], detail: "N = {steps:count}" },
      {
        each: "lines", head: "{each}", cell: ["{verdict}", "{survive} of {trials}", "not run"], detail: "{error:error}", short: "{error:digit}", tone: "{verdict}",
        hint: [
          "{each}, {row.scene}: {verdict}[{!ending=refused}, {ending:outcome}[ {detail}]][{?ending=refused}, {detail}][, {error:error} of the value]" +
            "[, rounding from t = {rounding_from:three} on][, {seconds:time}[{?wall_clock} of the wall clock]]",
          "[stops rightly {stop}][{?stop}{?refused}, ][refuses {refused}]",
        ],
        opened: openedTrial,
      },
    ],
  },
  rates: {
    caption: "Observed and theoretical rates by scene and scheme", filter: "line",
    columns: [lineColumn, { head: "steps", cell: "{steps.0:count} to {steps.1:count}" }, ...rateColumns("error at the end", "end"), ...rateColumns("maximum error over all steps", "maximum")],
  },
  drift: {
    caption: "Drift from the constraints by scene, formulation and scheme", filter: "line",
    columns: [
      { head: "formulation", cell: "{formulation}" }, { ...lineColumn, detail: "" }, { head: "N", cell: "{steps:count}" },
      ...driftColumns("internal drift", "internal"), ...driftColumns("independent drift", "independent"),
      { head: "error at the end", cell: "{error_end:error}" }, { head: "time", cell: "{time_minimum:time}" },
    ],
  },
  cost: {
    caption: "What each scheme used at its finest step count", filter: "line",
    columns: [
      lineColumn, { head: "N", cell: "{steps:count}" }, { head: "time", cell: "{time_minimum:time}[{?wall_clock} of the wall clock]" },
      { head: "first run", cell: "{first_seconds:time}" },
      { head: "error at the end", cell: "{error_end:error}" }, { head: "digits (mescd)", cell: "{mescd:tenths}" }, { head: "states", cell: "{states:count}" },
      { head: "start weights", cell: "{start_weights:count}" }, { head: "rhs calls", cell: "{rhs_calls:count}" },
      { head: "Newton iterations", cell: ["{newton.iterations:count} (to {newton.tolerance:error})", "{?explicit}explicit"] }, { head: "history", cell: "{history_bytes:bytes}" },
    ],
  },
  expansion: {
    caption: "States and times of the decoupled chain and the commensurate expansion",
    columns: [titleColumn, { head: "N", cell: "{steps:count}" }, ...stateColumns("chain", "chain"), ...stateColumns("expansion", "expansion"), { head: "time ratio", cell: "{ratio:hundredths}" }],
  },
  reference: {
    caption: "The reference's own error against the smallest error measured",
    columns: [
      titleColumn, { head: "rests on", cell: "{evidence}", detail: "computed in {seconds:time}" },
      ...referenceColumns("error at the end", "end"), ...referenceColumns("largest error over all times", "maximum"),
    ],
  },
  failures: {
    caption: "Refused and failed runs with their reasons", filter: "lines",
    columns: [{ head: "scheme", cell: "{lines}" }, { head: "N or accuracy", cell: "[{steps:count}][{requested:error}]" }, { head: "reason", cell: "{:ending}[ ... {last}]" }],
  },
  schemes: {
    caption: "The schemes and where they come from", filter: "scheme",
    columns: [{ head: "scheme", cell: "{scheme}" }, { head: "title", cell: ["{title}", "another program, or another version of fdebench"] }, { head: "source", cell: "{source}" }],
  },
  sessions: {
    caption: "Where and with what the numbers were made",
    columns: [{ head: "session", cell: "{property}" }, { each: "numbers", head: "{each}", cell: "{text}" }],
    properties: ["date", "machine", "cores", "system", "compiler", "flags", "commit", "version", "node", "disturbed times"],
  },
};
