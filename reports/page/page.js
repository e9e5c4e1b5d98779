// Builds the page from its data: sections with paragraphs, charts and tables. Numbers arrive as text.

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Ids may break behind their underscores, labels behind each setting.
const breakable = (text) => text.split(/(?<=[_,:])/).flatMap((part, i) => (i ? [element("wbr"), part] : [part]));

// Step counts, times and numbers like 1.2e-7 may not break.
const unbroken = (text) => text.split(/([Nt] = [^\s,]+|\S+e-\d+)/).map((part, i) => (i % 2 ? element("span", {}, part) : part));

function cellContent(cell, lines) {
  const parts = cell.marked ? [element("mark", {}, cell.text)] : breakable(cell.text);
  if (cell.line) parts.unshift(element("i", { class: "swatch", style: `background:${colourOf(lines, cell.line)}` }));
  if (cell.detail) parts.push(element("small", {}, ...unbroken(cell.detail)));
  return parts;
}

// data-column repeats the heading for narrow screens, where an answer's cells stand below each other.
function tableRow(row, columns, lines) {
  return element("tr", {}, ...row.map((cell, i) => i === 0
    ? element("th", { scope: "row" }, ...cellContent(cell, lines))
    : element("td", { "data-column": columns[i].text }, ...cellContent(cell, lines))));
}

function tableGroup(group, columns, lines) {
  const rows = group.rows.map((row) => tableRow(row, columns, lines));
  if (group.title) {
    rows.unshift(element("tr", { class: "group" }, element("th", { scope: "rowgroup", colspan: columns.length }, group.title)));
  }
  return element("tbody", {}, ...rows);
}

// The headings that neighbouring columns share, each over all of them.
function sharedHeadings(columns) {
  const spans = [];
  for (const { over } of columns) {
    if (spans.at(-1)?.over === over) spans.at(-1).colspan += 1;
    else spans.push({ over, colspan: 1 });
  }
  return spans.map(({ over, colspan }) =>
    over ? element("th", { scope: "colgroup", colspan }, over) : element("td", { colspan }));
}

function tableHead(columns) {
  const row = element("tr", {}, ...columns.map((column) => element("th", { scope: "col" }, ...breakable(column.text))));
  if (!columns.some((column) => column.over)) return element("thead", {}, row);
  return element("thead", {}, element("tr", {}, ...sharedHeadings(columns)), row);
}

// A table in a frame of its own, which scrolls where the screen is narrower.
function tableFrame(table, lines) {
  return element("div", { class: "frame", role: "region", tabindex: "0", "aria-label": table.caption },
    element("table", {}, element("caption", {}, table.caption), tableHead(table.columns),
      ...table.groups.map((group) => tableGroup(group, table.columns, lines))));
}

function drawCharts(scene, lines, kind, frame) {
  const actions = { export: true, source: false, compiled: false, editor: false };
  for (const { title, spec } of chartsOf(scene, lines, kind)) {
    const place = element("div", { class: "chart" });
    frame.append(element("figure", {}, element("figcaption", {}, title), place));
    vegaEmbed(place, spec, { actions, renderer: "svg", downloadFileName: `${scene.id}` });
  }
}

let linked = "";

// A variant of the scene before it is linked by what it varies only.
function link(section) {
  const variant = linked && section.title.startsWith(`${linked} (`);
  const text = variant ? section.title.slice(linked.length + 1) : section.title;
  if (!variant) linked = section.title;
  document.querySelector("nav").append(element("a", { href: `#${section.id}` }, text));
}

// What of a section depends on the kind of error: its table and its charts.
function showKind(section, lines, kind, place) {
  const shown = [];
  const table = section.tables?.[kind.id] ?? section.table;
  if (table) shown.push(tableFrame(table, lines));
  if (section.points) shown.push(element("div", { class: "charts" }));
  place.replaceChildren(...shown);
  if (section.points) drawCharts(section, lines, kind, shown.at(-1));
}

function show(section) {
  const heading = element("h2", {}, section.title);
  if (section.name) heading.append(" ", element("code", {}, section.name));
  const place = element("div");
  document.querySelector("main").append(element("section", { id: section.id }, heading,
    ...section.paragraphs.map((text) => element("p", {}, text)), place));
  link(section);
  return place;
}

// The controls name a norm and a scale; both together are a kind of error.
function chosenKind(kinds) {
  const [norm, scale] = ["norm", "scale"].map((name) => document.getElementById(name).value);
  return kinds.find((kind) => kind.norm === norm && kind.scale === scale);
}

const data = JSON.parse(document.getElementById("data").textContent);
document.getElementById("sessions").append(tableFrame(data.sessions, data.lines));
const places = data.sections.map(show);
const draw = (changed) => data.sections.forEach((section, i) => {
  if (!changed || section.tables || section.points) showKind(section, data.lines, chosenKind(data.kinds), places[i]);
});
draw(false);
for (const name of ["norm", "scale"]) document.getElementById(name).addEventListener("change", () => draw(true));
