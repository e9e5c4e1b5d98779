// SPDX-License-Identifier: MIT
// Names of lines short enough for the cells of a map: bdf4 as it stands, spectral_collocation as sc, l1, graded as l1g.

const initials = (words) => words.map((word) => word.slice(0, 1) + (/^\D.*?(\d)/.exec(word)?.[1] ?? "")).join("");

// The shortest one that nobody has: more and more of the first word, at last a number.
function shortNameOf(line, taken) {
  const [scheme, ...means] = line.split(", ");
  const [first = scheme, ...rest] = scheme.split("_").filter(Boolean);
  const end = initials(means);
  const choices = [...(scheme.length <= 4 ? [scheme] : []), initials([first, ...rest]), ...[2, 3].map((letters) => first.slice(0, letters) + initials(rest)), ...[2, 3, 4, 5, 6, 7, 8, 9].map((number) => initials([first, ...rest]) + number)];
  return choices.map((choice) => choice + end).find((name) => !taken.has(name)) ?? line;
}

function shortNames(lines) {
  const names = new Map();
  for (const line of lines) names.set(line, shortNameOf(line, new Set(names.values())));
  return names;
}
