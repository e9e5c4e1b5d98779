// node svg.mjs SPEC TABLE OUT: draws a Vega-Lite specification over a table, as SVG, with the packages of the report. The
// table is CSV or, by its name, JSON lines.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const installed = createRequire(new URL("../../reports/package.json", import.meta.url));
const load = (name) => import(pathToFileURL(installed.resolve(name)));
const [vega, lite] = await Promise.all(["vega", "vega-lite"].map(load));

const [spec, table, out] = process.argv.slice(2);
if (!out) {
  console.error("node svg.mjs SPEC TABLE OUT");
  process.exit(2);
}
const chart = JSON.parse(readFileSync(spec, "utf8"));
const text = readFileSync(table, "utf8");
chart.data = {
  values: table.endsWith(".jsonl")
    ? text.trimEnd().split("\n").map((line) => JSON.parse(line))
    : vega.read(text, { type: "csv", parse: "auto" }),
};
const view = new vega.View(vega.parse(lite.compile(chart).spec), { renderer: "none" });
writeFileSync(out, `${await view.toSVG()}\n`);
