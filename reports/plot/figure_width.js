// SPDX-License-Identifier: MIT
// A figure is as wide as it is asked to be, its letters as high as those of captions.

// Without a browser Vega takes letters for much wider than those of Times are, which stretches legends and margins.
const emsOf = (letter) => (/[ijlt.,:;'|/ I]/.test(letter) ? 0.28 : /[frsJ-]/.test(letter) ? 0.36 : /[mwM]/.test(letter) ? 0.78 : /[A-Z]/.test(letter) ? 0.68 : 0.5);
const widthOfText = ({ fontSize = paper.letters }, text) => fontSize * [...String(text ?? "")].reduce((sum, letter) => sum + emsOf(letter), 0);

function drawing() {
  if (!request.vega) throw new Error("this fdebench was built without the packages of setup.sh");
  vm.runInThisContext(request.vega);
  vega.textMetrics.width = widthOfText;
  return (spec) => new vega.View(vega.parse(vegaLite.compile(spec).spec), { renderer: "none" }).toSVG();
}

const widthOf = (svg) => Number(/width="([\d.]+)"/.exec(svg)[1]);

// The frames wider or narrower, what has a shape of its own higher or lower too.
const resized = (spec, width, keepsShape) => (spec.vconcat || spec.hconcat
  ? { ...spec, ...Object.fromEntries(["vconcat", "hconcat"].filter((name) => spec[name]).map((name) => [name, spec[name].map((panel) => resized(panel, width, keepsShape))])) }
  : { ...spec, width, height: keepsShape ? (spec.height * width) / spec.width : spec.height });
const widthOfFrame = (spec) => (spec.hconcat ?? spec.vconcat ? widthOfFrame((spec.hconcat ?? spec.vconcat)[0]) : spec.width);

// The drawing at the width of a column; its content keeps its shape, because the viewBox stays.
function shrunk(svg) {
  const part = paper.width / widthOf(svg), height = Number(/height="([\d.]+)"/.exec(svg)[1]);
  return svg.replace(/ width="[\d.]+"/, ` width="${paper.width.toFixed(1)}"`).replace(/ height="[\d.]+"/, ` height="${(height * part).toFixed(1)}"`);
}

// The specification whose frame, axes and legend together are as wide as `wanted`, and its drawing. Ticks may change with the width.
async function drawnAs(wanted, { spec, keepsShape }, draw) {
  let svg = await draw(spec), fits = spec;
  for (let turn = 0; turn < 4 && Math.abs(widthOf(svg) - wanted) > 0.5; ++turn) {
    const width = widthOfFrame(fits) + (wanted - widthOf(svg)) / panels.length;
    fits = resized(fits, Math.max(width, paper.width / (3 * panels.length)), keepsShape);
    svg = await draw(fits);
  }
  return { spec: fits, svg };
}

// As wide as a column. What does not fit, as a long name in a legend, makes a wider drawing that is reduced as a whole.
async function fitted(figure) {
  const draw = drawing();
  let drawn = await drawnAs(paper.width, figure, draw);
  if (widthOf(drawn.svg) > paper.width + 0.5) {
    const wanted = widthOf(drawn.svg);
    drawn = await drawnAs(wanted, { ...figure, spec: resized(figure.spec, wanted, figure.keepsShape) }, draw);
    console.log(`what is drawn is wider than the figure, and its letters have ${((8 * paper.width) / widthOf(drawn.svg)).toFixed(1)} points: give a larger --width or shorter names by --name`);
    return { spec: drawn.spec, svg: shrunk(drawn.svg) };
  }
  // The last fraction of a pixel is white.
  const width = ` width="${paper.width.toFixed(1)}"`;
  return { spec: drawn.spec, svg: drawn.svg.replace(/ width="[\d.]+"/, width).replace(/(<rect) width="[\d.]+"/, `$1${width}`).replace(/ viewBox="0 0 [\d.]+ /, ` viewBox="0 0 ${paper.width.toFixed(1)} `) };
}
