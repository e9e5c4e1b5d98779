// node svg.mjs SPEC CSV OUT: draws a Vega-Lite specification over a table, as SVG, with the packages of the report.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const installed = createRequire(new URL("../../reports/package.json", import.meta.url));
const load = (name) => import(pathToFileURL(installed.resolve(name)));
const [vega, lite] = await Promise.all(["vega", "vega-lite"].map(load));

const [spec, csv, out] = process.argv.slice(2);
if (!out) {
  console.error("node svg.mjs SPEC CSV OUT");
  process.exit(2);
}
const chart = JSON.parse(readFileSync(spec, "utf8"));
chart.data = { values: vega.read(readFileSync(csv, "utf8"), { type: "csv", parse: "auto" }) };
const view = new vega.View(vega.parse(lite.compile(chart).spec), { renderer: "none" });
writeFileSync(out, `${await view.toSVG()}\n`);
