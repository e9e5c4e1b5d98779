// SPDX-License-Identifier: MIT
// The colour, the shape and the dashes of each line: of a scheme always the same, on every page and in every figure.

const isDark = matchMedia("(prefers-color-scheme: dark)").matches;

// Okabe and Ito's colours, distinguished by most colour-blind readers; yellow is left out, it is too faint on white. Their black
// is the colour of the text.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", isDark ? "#c4c8ce" : "#333333", "#8c564b"];
const lineDashes = [[], [7, 3], [12, 3, 2, 3]];
const shapes = ["circle", "square", "triangle-up", "diamond", "cross", "triangle-down", "triangle-right", "triangle-left"];

// Every colour with every shape once: the colours in turn, with the next shapes and other dashes in each round.
function markAt(place) {
  const round = Math.floor(place / colours.length);
  return { colour: colours[place % colours.length], shape: shapes[(place + round) % shapes.length], dashes: lineDashes[(place + 2 * round) % lineDashes.length] };
}
const places = Array.from({ length: colours.length * shapes.length }, (_, place) => place);

// The place of the mark of a scheme: placesOfSchemes has the numbers of schemes/list.def (assets.S). -1: it is not in that list.
const placeOfMark = (id) => (Object.hasOwn(placesOfSchemes, id) ? placesOfSchemes[id] : -1);

// Of a scheme on another grid: its colour with another shape. What is not in that list, an external program or a
// scheme of somebody's own, has what is left, in the order of the lines; beyond 64 lines marks are repeated.
function marksOf(lines) {
  const marks = new Map();
  const used = new Set();
  const mark = (line, place) => {
    used.add(place);
    marks.set(line, markAt(place));
  };
  for (const line of lines) if (placeOfMark(line) >= 0) mark(line, placeOfMark(line));
  const isFree = (place) => !used.has(place), isLeft = (place) => isFree(place) && place >= Object.keys(placesOfSchemes).length;
  const give = (line, wanted) => mark(line, wanted.find(isLeft) ?? places.find(isLeft) ?? places.find(isFree) ?? marks.size % places.length);
  const others = lines.filter((line) => !marks.has(line)), schemeAt = (line) => placeOfMark(line.split(",")[0]);
  for (const line of others.filter((one) => schemeAt(one) >= 0)) {
    const later = schemeAt(line) + colours.length * shapes.length / 2;
    give(line, places.map((_, round) => (later + round * colours.length) % places.length));
  }
  for (const line of others.filter((one) => schemeAt(one) < 0)) give(line, []);
  return marks;
}

const marksOfLines = new WeakMap();
function markOf(lines, line) {
  if (!marksOfLines.has(lines)) marksOfLines.set(lines, marksOf(lines));
  return marksOfLines.get(lines).get(line) ?? marksOf([line]).get(line);
}
const colourOf = (lines, line) => markOf(lines, line).colour;
const shapeOf = (lines, line) => markOf(lines, line).shape;
const dashesOf = (lines, line) => markOf(lines, line).dashes;
