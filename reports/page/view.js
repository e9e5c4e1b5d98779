// SPDX-License-Identifier: MIT
// What of the page is shown: a kind of error, an accuracy, a machine, scenes, schemes. It follows the section in the address, as in
// #scene-pendulum?norm=end&schemes=l1,bdf4, so that a link restores it.

const schemeOf = (line) => line.split(",")[0];
const controls = Object.fromEntries(["norm", "scale", "accuracy", "machine", "scene"].map((name) => [name, document.getElementById(name)]));
const unset = Object.fromEntries(Object.entries(controls).map(([name, control]) => [name, control.value]));
const schemeBoxes = () => [...document.querySelectorAll("#of-schemes input")];

// An address with a broken escape is taken as it is.
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

const addressOf = () => {
  const [place, view = ""] = decoded(location.hash.slice(1)).split("?");
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
  const { schemes } = viewNow(), none = schemeBoxes().every((box) => !box.checked);
  document.querySelector("#of-schemes summary").textContent = schemes ? `Schemes: ${schemes.length} of ${schemeBoxes().length}` : none ? "Schemes: all, none is chosen" : "Schemes: all";
}

// Whether the view leaves out some of what there is; a kind of error leaves out nothing.
const isPart = ({ accuracy, machine, scene, schemes }) => Boolean(accuracy || machine || scene.trim() || schemes);

function showEverything() {
  for (const name of ["accuracy", "machine", "scene"]) controls[name].value = unset[name];
  for (const box of schemeBoxes()) box.checked = true;
  document.getElementById("view").dispatchEvent(new Event("change"));
}

// A sentence on what the view leaves, with the way back.
function leftSaid(text) {
  return [text, " ", buttonFor(showEverything, {}, "Show everything")];
}

// Beside the controls, where the view leaves something out: how much is left.
function sayWhatIsShown(view, sections) {
  const scenes = sections.filter(({ answers, plane }) => answers || plane), left = scenes.filter((section) => wantsScene(view, section)).length, place = document.getElementById("shown");
  const text = say(statements.shown, {
    ...view, scene: view.scene.trim(), schemes: view.schemes?.length, all_schemes: schemeBoxes().length,
    scenes: left, all_scenes: scenes.length, is_empty: left === 0, fade: [view.schemes && "schemes", view.machine && "machines"].filter(Boolean),
  });
  place.hidden = !isPart(view);
  place.replaceChildren(...(isPart(view) ? leftSaid(text) : []));
}

function offerSchemes(lines) {
  const set = (checked) => () => {
    for (const box of schemeBoxes()) box.checked = checked;
    schemeBoxes()[0]?.dispatchEvent(new Event("change", { bubbles: true }));
  };
  const boxes = [...new Set(lines.map(schemeOf))].map((scheme) =>
    element("label", {}, element("input", { type: "checkbox", value: scheme, checked: "" }), ` ${scheme}`));
  document.querySelector("#of-schemes div").append(...boxes, buttonFor(set(true), {}, "all"), buttonFor(set(false), {}, "none"));
}

// Results of one machine have no choice of it.
function offerMachines(machines) {
  const names = [...new Set(machines)];
  if (names.length < 2) return;
  document.getElementById("of-machine").hidden = false;
  controls.machine.append(...names.map((name) => element("option", {}, name)));
}

// Whether a section's scene is wanted; sections without one are.
const wantsScene = ({ scene }, { runs, plane, title, name }) =>
  !(runs || plane) || [title, name].some((text) => text.toLowerCase().includes(scene.trim().toLowerCase()));
const wantsLine = ({ schemes }, line) => !schemes || schemes.includes(schemeOf(line));

// session: from 1 on; undefined where there is one only.
const wantsSession = ({ machine }, session) => !machine || session === undefined || data.sessions[session - 1].machine === machine;
const wantsAccuracy = ({ accuracy }, value) => !accuracy || value === undefined || value === Number(accuracy);

// Columns of accuracies or of lines; a row of the lines that its table is about; a row of a map that leads to no section is a trial's and
// has its scene for a heading.
const wantsColumn = (view, { each }) => (typeof each === "string" ? wantsLine(view, each) : wantsAccuracy(view, each));
const wantsLines = (view, lines) => lines === undefined || [lines].flat().some((line) => wantsLine(view, line));
const wantsTrial = (view, table, title, { to, text }) => !table.map || Boolean(to) || wantsScene(view, { runs: true, title, name: text });
const isFaint = (view, { line, facts }) => Boolean(line) && !(wantsLine(view, line) && wantsSession(view, facts.session));

// Whether a section has something that the view shows.
function hasContent(view, section, kind, sections) {
  if (!wantsScene(view, section)) return false;
  if (section.groups) return viewed(tableOf(section, kind, sections), view, sections).groups.length > 0;
  if (section.regions) return pointsOfRegions(section.regions, (line) => wantsLine(view, line)).length > 0;
  if (section.schemes) return viewed(tableOf(section, kind, sections), view, sections).groups.length > 0;  // the map
  return !section.parameter || wantsRuns(view, section);
}
const wantsRuns = (view, { runs }) => runs.line.some((line, i) => wantsLine(view, runs.lines[line]) && wantsSession(view, runs.session?.[i]));

// A table as this view shows it. sections: all of the page.
function viewed(table, view, sections) {
  const kept = table.columns.map((column, i) => i).filter((i) => table.columns[i].each === undefined || wantsColumn(view, table.columns[i]));
  const unwanted = new Set(sections.filter((section) => !wantsScene(view, section)).flatMap(({ id, title }) => [id, title]));
  const wantsRow = ([heading], title) => wantsAccuracy(view, heading.facts.accuracy) && !unwanted.has(heading.to) && !unwanted.has(heading.text) &&
    wantsLines(view, heading.facts[table.filter]) && wantsTrial(view, table, title, heading);
  const groups = table.groups.filter(({ title }) => !unwanted.has(title)).map(({ title, rows }) => ({
    title, rows: rows.filter((row) => wantsRow(row, title)).map((row) => kept.map((i) => ({ ...row[i], faint: isFaint(view, table.fades === "rows" ? row.find(({ line }) => line) ?? {} : table.fades ? row[i] : {}) }))),
  }));
  return { ...table, columns: kept.map((i) => table.columns[i]), groups: groups.filter(({ rows }) => rows.length > 0) };
}

// Where each line is cheapest among the cells of the map that the view shows, as a map of its facts.
function winsIn({ groups }) {
  const cells = groups.flatMap(({ rows }) => rows.flatMap(([{ facts: { name } }, ...row]) => row.filter(({ line }) => line).map((cell) => ({ ...cell, scene: name.split(":")[0] }))));
  const factsOf = (won) => {
    const count = (scene) => won.filter((cell) => cell.scene === scene).length;
    const ratios = won.map(({ facts: { second } }) => second?.ratio).filter(Boolean).sort((a, b) => a - b), next = ratios[Math.floor(ratios.length / 2)];
    const scenes = [...new Set(won.map(({ scene }) => scene))].sort((a, b) => count(b) - count(a));
    return { won: won.length, cells: cells.length, scenes, next, as_quick: next < 1.05 };
  };
  const shown = cells.filter(({ faint }) => !faint);
  return new Map([...new Set(shown.map(({ line }) => line))].map((line) => [line, factsOf(shown.filter((cell) => cell.line === line))]));
}

// What speaks against a line on the scenes that the view shows.
function againstViewed(against, view, sections) {
  if (!view.scene.trim()) return against;
  const titles = new Map(sections.filter(({ answers }) => answers).map(({ title, name }) => [name, title]));
  const wanted = (id) => wantsScene(view, { runs: true, title: "", name: id }) ||
    [...titles].some(([name, title]) => name.split(":")[0] === id && wantsScene(view, { runs: true, title, name }));
  return against?.map((of) => Object.fromEntries(Object.entries(of).map(([verdict, ids]) => [verdict, Array.isArray(ids) ? ids.filter(wanted) : ids])));
}

// What is said of each line, of the cells of the map that the view shows: { line, won, texts }, the first with the most cells there, then in
// the whole map. Where a line is nearest and how many trials it survives is known of all only.
function verdictsViewed({ schemes }, map, kind, view, sections) {
  const [wins, all] = [viewed(map, view, sections), map].map(winsIn), is_part = Boolean(view.scene.trim() || view.accuracy || view.machine);
  const faultsOf = ({ against, trials }) => say(statements.faults, { against: againstViewed(against, view, sections), trials: !view.scene.trim() && trials });
  const wonIn = (of, { line }) => of.get(line)?.won ?? 0;
  return schemes.filter(({ line }) => wantsLine(view, line)).map(({ line, nearest, ...facts }) => ({
    line, won: wonIn(wins, { line }), texts: [say(statements.wins, { ...wins.get(line), is_part, nearest: nearest?.[kind.id] }), faultsOf(facts)],
  })).sort((a, b) => b.won - a.won || wonIn(all, b) - wonIn(all, a));
}
