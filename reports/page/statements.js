// SPDX-License-Identifier: MIT
// What the page says of runs, lines and endings; sections and other statements name these (say.js).

const statements = {
  norm: { end: "error at the end", maximum: "maximum error" },
  scale: { absolute: "" },
  kind: "{scale:scale} {norm:norm}[ in {columns}]",

  // Runs, and why one is the cheapest.
  timed: "{seconds:time} ({low:time} ... {high:time})[{?wall_clock} of the wall clock]",
  run: "[{grid}, ][accuracy {requested:error}, ]N = {steps:count}, error {error:error}[, {:timed}][{!seconds}, not timed]" +
    "[, {first_seconds:time} in the first run of a process][, {later_seconds:time} in later runs][, session {session}]",
  at_steps: "{line} at N = {steps:count}",
  cheapest: ["{line}", "{?untimed}reached, not timed yet", "{?best}none measured reaches it", "no run has this error"],
  its_run: ["{?line}{:run}", "best: {best.line}, {best:run}"],
  why: [
    "{?is_no_better}the solution is so small that a constant is as accurate",
    "{?is_rounding}this error of {best.line} is rounding error",
    "the reference is known to {known_up_to:error} only",
    "{needed.line} would need about N = {needed.steps:rough} ({needed.low:rough} ... {needed.high:rough})[ and {needed.seconds:time}], by its errors so far",
    "{?best}no error so far falls with the steps",
    "within noise of {ties:few}",
    "{second.ratio:ratio} times as quick as {second.line}: {second:reason}",
    "{?line}no other line gets there[; the next best, {next_best.line}, has {next_best.error:error}]",
  ],
  reason: [
    "the first run of {line} takes {setup:time} for start weights and tables",
    "a step takes {step_seconds.0:time} where one of {line} takes {step_seconds.1:time}",
    "{steps.0:count} steps are enough where {line} needs {steps.1:count}[, by its rate, {rates.0:tenths} against {rates.1:tenths}]" +
      "[, although a step takes {dearer:tenths} times as long]",
  ],

  // The conclusion on a scene.
  range: "{line} [from {from:power} ]to {to:power} ({seconds:time/ to })",
  conclusion: "[Cheapest: {cheapest:range/, then }.] [Only {leader.line} reaches {leader.accuracy:power}{!leader.second}.]" +
    " [To {leader.accuracy:power} {leader.line} leads: {leader.second:reason}.]" +
    " [No run is within {limit.accuracy:power}: the best has {limit.error:error}, by {limit.line}[{?limit.is_rounding}, which is rounding]" +
    "[{?limit.is_unresolved}, as far as the reference is known].]" +
    " [Some runs of {ended} end early.] [{refused:count} scheme[{!refused=1}s] refuse[{?refused=1}s] it, with the reason under Refused and failed.]",

  // What is said of a family. A part of it is where a line is mostly the cheapest.
  part: "{inside:percent} where {parameter} [{?from}≥][{!from}≤] {bound:three}, {outside:percent} elsewhere",
  winner: "{line} in {share:percent}[ ({where:part})]",
  interval: "{value:two}[ ({low:two} to {high:two})]",
  best: [
    "Without knowing them take {line}: in 95 % of the scenes that some scheme solves it takes at most {regret:regret} times the least time[; the intervals do not decide against {undecided:few}].",
    "No scheme is the one to take without knowing them: none solves 95 % of the scenes; {line} solves the most.",
  ],
  regret: ["{value:two} ({low:two} to {high:two})", "{value:two} (from {low:two} on)"],
  family: ["Over {parameters/ and } of {title} ({members} scenes, {kind:kind} to {accuracy:power}) the cheapest is {winners:winner/; }[; {rest} more].[ The first two are within noise of each other in {tied:percent} of the scenes.]" +
    "[ No scheme gets there in {unsolved:percent}.] {best:best}",
    "Over {parameters/ and } of {title} ({members} scenes, {kind:kind}[ to {accuracy:power}]) no scheme gets there.",
  ],

  wins_of: "{line}: {count} of {of} scenes",

  // What is said of a line beside the map of answers.
  wins: [
    "Cheapest in {won} of {cells} cells: {scenes:few}.[{!as_quick} The next takes {next:two} times as long, in the median.]" +
      "[{?as_quick} The next is as quick, in the median.]",
    "{?is_part}Wins none of these cells.",
    "Cheapest nowhere; nearest on {nearest.scene} to {nearest.accuracy:power}, in {nearest.ratio:three} times the least time.",
    "Reaches none of these accuracies.",
  ],
  fault: ["fails on {fails:few}", "inaccurate on {inaccurate:few}", "refuses {refuses:scenes}[ ({reason})]"],
  faults: ["{against:fault/; }.", "{?trials=1}Survives its trial.", "Survives all {trials} trials."],

  // How runs end; the detail of a refusal is its reason.
  outcome: {
    not_finite: "not finite",
    not_converged: "Newton's method did not converge",
    undetermined: "the values at the end do not determine the missing initial values",
    step_too_large: "steps are too long for a mode that grows",
    step_too_small: "the error test failed down to the smallest step",
    blow_up: "the solution grows without bound: it blows up",
    sliding: "the solution slides along a switch of its right-hand side",
    singular: "ran into the singularity",
    out_of_budget: "out of its budget of time",
    event: "ended by an event",
    accuracy_lost: "accuracy lost",
    overflow: "the solution overflows",
    no_reference: "no reference:",
    passed_singularity: "passed a singularity of the solution:",
    false_singularity: "unlike the solution, ran into the singularity",
    program_failed: "the program failed:",
    refused: "refused:",
  },
  ending: "{ending:outcome}[ {detail}]",
  judged: "{verdict} ({:ending})",

  // What the controls leave.
  shown: [
    "{?is_empty}Nothing is left: no scene has “{scene}” in its name.",
    "Shown: [{scenes} of {all_scenes} scenes][, {schemes} of {all_schemes} schemes][, errors to {accuracy}][, runs of {machine}].[ Cells of other {fade/ or } are faint.]",
  ],

  // Of scenes and sections.
  discontinuity: "The solution is not continuous in {parameter} here: as {parameter} tends to its value, {limit}.",
  kept: "{formulation} with {line} ({drift:error}[, error {error_end:error}] at N = {steps:count})",
  changes: { endings: "Verdicts and endings", errors: "Errors", times: "Times" },
};
