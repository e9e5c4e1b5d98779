// SPDX-License-Identifier: MIT
// What of the page is shown: a kind of error, an accuracy, a machine, scenes, schemes. It follows the section in the address, as in
// #scene-pendulum?norm=end&schemes=l1,bdf4, so that a link restores it.

const schemeOf = (line) => line.split(",")[0];
const controls = Object.fromEntries(["norm", "scale", "accuracy", "machine", "scene"].map((name) => [name, document.getElementById(name)]));
const unset = Object.fromEntries(Object.entries(controls).map(([name, control]) => [name, control.value]));
const schemeBoxes = () => [...document.querySelectorAll("#schemes input")];

const addressOf = () => {
  const [place, view = ""] = decodeURIComponent(location.hash.slice(1)).split("?");
  return { place, view: new URLSearchParams(view) };
};

function viewNow() {
  const [chosen, boxes] = [schemeBoxes().filter((box) => box.checked), schemeBoxes()];
  return {
    ...Object.fromEntries(Object.entries(controls).map(([name, control]) => [name, control.value])),
    schemes: chosen.length === 0 || chosen.length === boxes.length ? null : chosen.map((box) => box.value),
  };
}

function writeAddress() {
  const view = viewNow();
  const said = Object.entries(view).filter(([name, value]) => name !== "schemes" && value !== unset[name]);
  if (view.schemes) said.push(["schemes", view.schemes.join(",")]);
  const text = said.map(([name, value]) => `${name}=${encodeURIComponent(value)}`).join("&");
  const { place } = addressOf();
  history.replaceState(null, "", `#${place}${text ? `?${text}` : ""}`);
}

function readAddress() {
  const { view } = addressOf();
  for (const [name, control] of Object.entries(controls)) control.value = view.get(name) ?? unset[name];
  const schemes = view.get("schemes")?.split(",");
  for (const box of schemeBoxes()) box.checked = schemes?.includes(box.value) ?? true;
  sayHowManySchemes();
}

function sayHowManySchemes() {
  const { schemes } = viewNow();
  document.querySelector("#schemes summary").textContent = schemes ? `Schemes: ${schemes.length} of ${schemeBoxes().length}` : "Schemes: all";
}

function offerSchemes(lines) {
  const all = element("button", { type: "button" }, "all"), none = element("button", { type: "button" }, "none");
  const set = (checked) => () => {
    for (const box of schemeBoxes()) box.checked = checked;
    schemeBoxes()[0]?.dispatchEvent(new Event("change", { bubbles: true }));
  };
  all.addEventListener("click", set(true));
  none.addEventListener("click", set(false));
  const boxes = [...new Set(lines.map(schemeOf))].map((scheme) =>
    element("label", {}, element("input", { type: "checkbox", value: scheme, checked: "" }), ` ${scheme}`));
  document.querySelector("#schemes div").append(...boxes, all, none);
}

// Results of one machine have no choice of it.
function offerMachines(machines) {
  const names = [...new Set(machines)];
  if (names.length < 2) return;
  document.getElementById("of-machine").hidden = false;
  controls.machine.append(...names.map((name) => element("option", {}, name)));
}

// Whether a section's scene is wanted; sections without one are.
const wantsScene = ({ scene }, { runs, title, name }) =>
  !runs || [title, name].some((text) => text.toLowerCase().includes(scene.trim().toLowerCase()));
const wantsLine = ({ schemes }, line) => !schemes || schemes.includes(schemeOf(line));

// session: from 1 on; undefined where there is one only.
const wantsSession = ({ machine }, session) => !machine || session === undefined || data.machines[session - 1] === machine;

const accuracyName = /^≤ 1e-\d+$/;
const wantsAccuracy = ({ accuracy }, text) => !accuracy || !accuracyName.test(text) || text === `≤ ${accuracy}`;

// A heading may be one scheme or several, of which one is wanted.
const isScheme = (text) => schemesMarked.includes(text) || schemeBoxes().some(({ value }) => value === text);
const wantsHeading = (view, { text, line }) => (line ? wantsLine(view, line)
  : !text.split(", ").every(isScheme) || text.split(", ").some((scheme) => wantsLine(view, scheme)));

// A map has columns of accuracies or of lines; a row that leads to no section is a trial's and has its scene for a heading.
const wantsColumn = (view, table, i) => (table.map && i > 0 && !accuracyName.test(table.columns[i].text) ? wantsLine(view, table.columns[i].text)
  : wantsAccuracy(view, table.columns[i].text));
const wantsTrial = (view, table, title, { to, text }) => !table.map || Boolean(to) || wantsScene(view, { runs: true, title, name: text });

// A table as this view shows it. sections: all of the page.
function viewed(table, view, sections) {
  const kept = table.columns.map((column, i) => i).filter((i) => wantsColumn(view, table, i));
  const unwanted = new Set(sections.filter((section) => !wantsScene(view, section)).flatMap(({ id, title }) => [id, title]));
  const wantsRow = ([heading], title) => wantsAccuracy(view, heading.text) && !unwanted.has(heading.to) && !unwanted.has(heading.text) &&
    wantsHeading(view, heading) && wantsTrial(view, table, title, heading);
  const groups = table.groups.filter(({ title }) => !unwanted.has(title)).map(({ title, rows }) => ({
    title, rows: rows.map((row) => row.map(cellOf)).filter((row) => wantsRow(row, title))
      .map((row) => kept.map((i) => ({ ...row[i], faint: Boolean(table.map && row[i].line && !(wantsLine(view, row[i].line) && wantsSession(view, row[i].session))) }))),
  }));
  return { ...table, columns: kept.map((i) => table.columns[i]), groups: groups.filter(({ rows }) => rows.length > 0) };
}

// Where each line is cheapest among the cells that the view shows, as { line: sentence }.
function winsIn({ groups }) {
  const cells = groups.flatMap(({ rows }) => rows.flatMap(([{ to }, ...row]) => row.filter(({ line }) => line).map((cell) => ({ ...cell, scene: to.replace("scene-", "").split(":")[0] }))));
  const sentence = (won) => {
    const count = (scene) => won.filter((cell) => cell.scene === scene).length;
    const scenes = [...new Set(won.map(({ scene }) => scene))].sort((a, b) => count(b) - count(a));
    const next = won.map((cell) => cell.next).filter(Boolean).sort((a, b) => a - b), middle = next[Math.floor(next.length / 2)];
    const margin = middle === undefined ? "" : middle < 1.05 ? " The next is as quick, in the median." : ` The next takes ${middle} times as long, in the median.`;
    return `Cheapest in ${won.length} of ${cells.length} cells: ${scenes.slice(0, 3).join(", ")}${scenes.length > 3 ? ` and ${scenes.length - 3} more` : ""}.${margin}`;
  };
  const lines = [...new Set(cells.filter(({ faint }) => !faint).map(({ line }) => line))];
  return Object.fromEntries(lines.map((line) => [line, sentence(cells.filter((cell) => cell.line === line))]));
}

// What is said of each line, of the cells that the view shows: where it wins, and elsewhere what speaks against it.
function verdictsViewed(section, kind, view, sections) {
  const rows = viewed(section.verdicts[kind.id], view, sections).groups.flatMap((group) => group.rows);
  if (!view.scene.trim() && !view.accuracy && !view.machine) return rows;
  const wins = winsIn(viewed(section.tables[kind.id], view, sections));
  const said = rows.map(([line, , ...rest]) => [line, { text: wins[line.line] ?? "Wins none of these cells." }, ...rest]);
  return said.sort(([a], [b]) => Number(b.line in wins) - Number(a.line in wins));
}
