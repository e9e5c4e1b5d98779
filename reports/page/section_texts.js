// SPDX-License-Identifier: MIT
// The sections of the page by their ids: their titles, what the contents call them, and their paragraphs and notes, which are templates
// (say.js) over the section's facts. A paragraph with `each` is said of every element of that list.

const sectionTexts = {
  answer: {
    title: "Which scheme is cheapest", brief: "Answer",
    paragraphs: [
      "{?schemes}The quickest measured run of each scene to each error. A click on a cell shows the run, why it is the quickest, and its command; one on a scene leads to " +
        "its charts and equations.",
    ],
    notes: [
      "[{?first_run}A time is that of the first run of a process, which computes start weights and tables.]" +
        "[{!first_run}A time is that of a later run: the first run of a process computes start weights and tables too, and its time is beside it.]",
      "{?several_sessions}The results were made in several sessions; times of different machines or builds do not compare. A run made more " +
        "than once counts with its last session.",
    ],
  },
  codes: {
    title: "Beside other codes", brief: "Codes",
    paragraphs: [
      "The quickest run of each code within each error, among all of its settings that were tried, and of fdebench among all schemes. Below the time of another code is how many times " +
        "as long it takes, or the smallest error that it has. A time is that of a solve in a process that has solved the problem before; a click on a cell shows the setting, the first solve and the start of the process.",
      "{?octave}GNU Octave interprets loops: where authors publish times of MATLAB for the same runs, those are 20 to 55 times shorter, on their machine (docs/peers.md).",
    ],
  },
  compared: {
    title: "Compared with the first results", brief: "Compared",
    paragraphs: [
      "{common} runs are in both, {only_before} only in the first, {only_now} only in the second, which the rest of the page is of. Where a " +
        "verdict got worse or an error grew, it is marked. Errors that moved by less than a hundredth, or by less than what rounding and the " +
        "reference leave open, are left out, and times whose 95 % intervals meet.",
    ],
  },
  stability: {
    title: "Stability: stiff and extreme", brief: "Trials",
    paragraphs: [
      "What becomes of each scheme where schemes break, each scene with one number of steps: ✓ survives, within a hundredth of the value at the end; ≈ inaccurate; ✗ fails, " +
        "with an error like the value itself or an early end; – refuses; ? not judged. Below is the error at the end as a part of the value. A click shows the reason and the command.",
    ],
    notes: [
      "A verdict takes the bound of the reference into account. A run stops rightly (✓) where the solution has a singularity, and is not judged where there is no reference or the " +
        "solution itself overflows. Rounding is said from when on it is at least a quarter of the error. Why each scheme fares as it does: docs/stability.md.",
    ],
  },
  regions: {
    title: "Stability: linear equations", brief: "Stability",
    paragraphs: [
      "What a scheme makes of D^γ y = λ y with steps h depends on z = λ h^γ alone. The solution decays to the left of the dashed ray, where " +
        "|arg z| > γπ/2; a scheme does to the left of its curve. A curve that stays in the right half bounds no step: the scheme may take any " +
        "where the solution decays. One that ends on the negative axis bounds them: z has to be inside. Of schemes with the same curve one is " +
        "drawn. fdebench stability prints the curves for any order.",
    ],
  },
  scene: {
    title: "{title}",
    paragraphs: [
      "{source}",
      "{discontinuities:discontinuity/ }",
      "Errors are over {compared_columns}, which all runs of this scene have: some programs print no other columns.",
      "Not in the charts, because the error at the end is exactly 0: {not_drawn:at_steps}.",
      "Times of whole processes, by the wall clock and with their start: {on_wall_clock}.",
    ],
  },
  family: {
    title: "{scene} over {plane.parameters/ and }",
    paragraphs: ["{source}"],
    notes: [
      "A time is the median of a scheme's quickest run to the accuracy. Wins within noise, where the 95 % interval of another's time meets that of the " +
        "winner, are no scheme's. Regret is a scheme's time over the least time of the same scene, infinite where it does not get there; its " +
        "quantiles are order statistics, with intervals that hold for every distribution (Hahn & Meeker 1991). The interval of a share is Wilson's " +
        "(1927). All are 95 % intervals that take the scenes for independent draws: of a lattice they say how much its size leaves open. Scenes " +
        "that no scheme solves do not count. The scheme to take without knowing the scene has the least 95 % quantile of regret.",
    ],
  },
  curve: {
    title: "{scene} over {parameter}",
    paragraphs: ["Every run has N = {steps:count}, the most steps that all lines have in common."],
  },
  rates: {
    title: "Observed and theoretical rates", brief: "Rates",
    paragraphs: [
      {
        each: "theorems",
        text: "At a fixed time t > 0 {scheme} shows {rate} on {scenes}, although the hypothesis of {theorem}, {hypothesis}, fails for these scenes. " +
          "In the maximum norm over all steps it does not: the error at t₁ is O(h) or worse. A larger slope there means that the first steps do " +
          "not dominate the fitted range yet. Rates belong to (scheme, smoothness, grid, norm).",
      },
      "Observed rates are least-squares slopes over the finest step counts, five at most; errors at rounding are left out. {deviating} of {fits} " +
        "differ from the theory by more than {largest_deviation}. They are marked: the fitted range may not be asymptotic, or the scene has " +
        "what the theory leaves out.",
    ],
  },
  drift: {
    title: "Drift from the constraints", brief: "Drift",
    paragraphs: [
      "The largest |f(t, q, v, w)| along the computed path, in the unit of f. The internal drift takes the scheme's own w at every step; the " +
        "independent one takes the derivative of fractional order of the computed path, by a rule of higher order than any scheme here. Growth " +
        "is p where the largest drift so far grows like t^p, 0 where it stays bounded. The rate in h is fitted over five step counts at most; " +
        "it is left out below a correlation of 0.95. No growth or rate where the drift is at rounding. The table is for the finest step count " +
        "that the lines of a scene share. The sentences compare, within the largest time that every formulation was given, each one's run with " +
        "the least drift, and of those at rounding the one with the least error.",
      { each: "best_in_time", text: "{title}: within {seconds:time}, the constraint is kept best by {best:kept}; then {others:kept}." },
      "With the scheme's own memory every run of these that did not diverge keeps the constraint to rounding ({rounding:digit}): {at_rounding}.",
    ],
  },
  cost: { title: "Cost at the finest step count", brief: "Cost" },
  expansion: {
    title: "Decoupled chain or commensurate expansion", brief: "Chain or expansion",
    paragraphs: [
      "Yin, Liu & Anh 2007 hold that the expansion into equal orders ({expansion}) has too many states, against their decoupled chain ({chain}). " +
        "Measured, at the finest step count that both have:",
    ],
  },
  reference: {
    title: "How far the reference is known", brief: "References",
    paragraphs: [
      "An error means something only as far as it is above the error of the reference itself: a bound where the solution is known in closed form " +
        "or as an inverse Laplace transform, an estimate where two methods that share nothing agree. It is set against the smallest error " +
        "measured on the scene. The first of the two methods is a collocation on panels, as spectral_collocation is; for that scheme the second " +
        "one vouches alone, exponentials within a Radau IIA method. What is stated covers the difference of the two; where it is more than a " +
        "tenth of an error, that is marked.",
      "Where two methods have to agree, it took {cost.seconds.0:time} to {cost.seconds.1:time} of a processor to compute a reference, as " +
        "fdebench exact does.[ The quickest scheme over a grid without start weights takes {cost.grid.ratio:rough} times as " +
        "long to an error of 1e-12, in the median of {cost.grid.scenes} scenes[, for {cost.grid.forecasts} of them by its errors so far].]" +
        "[ The quickest that takes an accuracy gets there in {cost.adaptive.seconds:time}, in the median of the {cost.adaptive.scenes} where " +
        "one was measured.]",
    ],
  },
  failures: {
    title: "Refused and failed", brief: "Refused and failed", folded: true,
    paragraphs: ["Every run that did not come to its end, or whose end says nothing about the solution, with the reason."],
  },
  schemes: { title: "The schemes", brief: "Schemes" },
};
const textsOf = ({ id, parameter, plane }) => sectionTexts[id] ?? (plane ? sectionTexts.family : parameter ? sectionTexts.curve : sectionTexts.scene);

// texts: paragraphs, which come first, or notes, which come last.
const saidOfSection = (section, texts) => (textsOf(section)[texts] ?? []).flatMap((paragraph) =>
  (paragraph.each ? (section[paragraph.each] ?? []).map((facts) => say(paragraph.text, facts)) : [say(paragraph, section)])).filter(Boolean);
