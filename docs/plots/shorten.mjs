// node shorten.mjs FILE...: reduces SVG of Vega or Graphviz, in place, to what a picture in a page needs: no comments, no
// labels for screen readers of its parts, no names of marks, no empty or invisible shapes, no attributes at their defaults,
// and curves of points within a tenth of a pixel.
import { readFileSync, writeFileSync } from "node:fs";

const tenths = (number) => Math.round(10 * number);
const written = (n) => `${n / 10}`.replace(/^(-?)0\./, "$1.");

// The points without those nearer than a tenth of a pixel to the line between their neighbours (Ramer, Douglas and Peucker).
function thinned(points) {
  const [first, last] = [points[0], points.at(-1)];
  const [dx, dy] = [last[0] - first[0], last[1] - first[1]];
  const length = Math.hypot(dx, dy);
  const distance = ([x, y]) =>
    length > 0 ? Math.abs(dy * (x - first[0]) - dx * (y - first[1])) / length : Math.hypot(x - first[0], y - first[1]);
  const distances = points.map(distance);
  const farthest = distances.indexOf(Math.max(...distances));
  if (distances[farthest] < 0.1) return [first, last];
  return [...thinned(points.slice(0, farthest + 1)).slice(0, -1), ...thinned(points.slice(farthest))];
}

// "Mx,yLx,yLx,y..." with steps in place of positions.
function shortLine(line) {
  const points = thinned(line.slice(1).split("L").map((point) => point.split(",").map(Number)));
  let [x, y] = points[0].map(tenths);
  let path = `M${written(x)},${written(y)}l`;
  for (const [nextX, nextY] of points.slice(1)) {
    const step = [tenths(nextX) - x, tenths(nextY) - y];
    if (step[0] === 0 && step[1] === 0) continue;
    const [dx, dy] = step.map(written);
    path += `${path.endsWith("l") || dx.startsWith("-") ? "" : " "}${dx}${dy.startsWith("-") ? "" : ","}${dy}`;
    [x, y] = [x + step[0], y + step[1]];
  }
  return path.endsWith("l") ? `${path}0,0` : path;
}

function shortened(svg) {
  let picture = svg
    .replace(/<!--[^]*?-->\n?|<title>.*?<\/title>\n?/g, "")
    .replace(/ id="([^"]*)"/g, (text, id) => (svg.includes(`url(#${id})`) ? text : ""))
    .replace(/ (aria-[a-z]+|role|class|pointer-events)="[^"]*"/g, "")
    .replace(/ (opacity="1"|fill-opacity="1"|stroke-width="1"|stroke-dasharray="1,0"|font-weight="normal"|x2="0"|y2="0")/g, "")
    .replace(/<path( d=""| d="M0,0h[^"]*"| display="none"| clip-path="[^"]*")+\/>/g, "")
    .replace(/M[-\d.e]+,[-\d.e]+(L[-\d.e]+,[-\d.e]+)+/g, shortLine)
    .replace(/ (d|transform|points)="[^"]*"/g, (coordinates) => coordinates.replace(/(\d+\.\d)\d+/g, "$1"));
  for (let before = ""; before !== picture; ) {
    before = picture;
    picture = picture.replace(/<g(?: [^>]*)?><\/g>/g, "").replace(/<g>(<(?:path|line|text)[^<]*(?:<\/text>)?)<\/g>/g, "$1");
  }
  return picture;
}

for (const file of process.argv.slice(2)) writeFileSync(file, `${shortened(readFileSync(file, "utf8")).trimEnd()}\n`);
