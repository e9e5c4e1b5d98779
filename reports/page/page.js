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

// Cells are texts, or say more; their text may be their line's.
const cellOf = (cell) => (typeof cell === "string" ? { text: cell } : { text: cell.line, ...cell });

function cellContent(cell, lines, painted, to) {
  const text = cell.marked ? [element("mark", {}, cell.text)] : breakable(cell.text);
  const parts = to && cell.text ? [element("a", { href: `#${to}` }, ...text)] : text;
  if (cell.line && !painted) parts.unshift(element("i", { class: "swatch", style: `background:${colourOf(lines, cell.line)}` }));
  if (cell.detail) parts.push(element("small", {}, ...unbroken(cell.detail)));
  return parts;
}

// A map's cell wears the colour of its line or its verdict; data-column repeats its heading for narrow screens, where the cells of a row wrap.
function mapAttributes(cell, column, lines) {
  const paint = cell.line ? { style: `--paint:${colourOf(lines, cell.line)};--strength:${Math.round(12 + 48 * (cell.strength ?? 0))}%` } : {};
  return { "data-column": column.text, ...(cell.tone && { "data-tone": cell.tone }), ...paint };
}

// A cell of the map stands for a row of its section's table, which says more.
function hintOf(cell, i, { to }, kind) {
  if (cell.hint || !to || i === 0) return cell.hint;
  const row = data.sections.find(({ id }) => id === to).tables[kind.id].groups[0].rows[i - 1];
  return row.slice(1).map((of) => cellOf(of).text).filter(Boolean).join(": ");
}

function tableRow(row, { columns, map }, lines) {
  const cells = row.map(cellOf);
  return element("tr", {}, ...cells.map((cell, i) => {
    const hint = hintOf(cell, i, cells[0], chosenKind(data.kinds));
    const attributes = { ...(hint && { title: hint }), ...(map && i > 0 && mapAttributes(cell, columns[i], lines)) };
    return element(i ? "td" : "th", i ? attributes : { scope: "row" }, ...cellContent(cell, lines, map, cells[0].to));
  }));
}

function tableGroup(group, table, lines) {
  const { columns } = table;
  const rows = group.rows.map((row) => tableRow(row, table, lines));
  if (group.title) {
    rows.unshift(element("tr", { class: "group" }, element("th", { scope: "rowgroup", colspan: columns.length }, group.title)));
  }
  return element("tbody", {}, ...rows);
}

// The headings that neighbouring columns share, each over all of them.
function sharedHeadings(columns) {
  const spans = [];
  for (const { over = "" } of columns) {
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
    element("table", table.map ? { class: "map" } : {}, element("caption", {}, table.caption), tableHead(table.columns),
      ...table.groups.map((group) => tableGroup(group, table, lines))));
}

// The chart's table, made when it is opened, and its numbers as a file.
function numbersOf(chart, section, kind, lines) {
  const titles = { error: kind.title, value: section.parameter };
  const save = element("a", { download: `${section.id}-${chart.id}.csv`, href: "" }, "CSV");
  save.addEventListener("click", () => save.setAttribute("href", `data:text/csv;charset=utf-8,${encodeURIComponent(csvOf(chart, titles))}`));
  const details = element("details", { class: "numbers" }, element("summary", {}, "Numbers"));
  details.addEventListener("toggle", () => {
    if (details.open && details.children.length === 1) details.append(save, tableFrame(numbersTable(chart, titles), lines));
  });
  details.open = Boolean(chart.open);
  return details;
}

function drawCharts(scene, { lines, kinds }, kind, frame) {
  const actions = { export: true, source: false, compiled: false, editor: false };
  for (const made of chartsOf(scene, lines, kind, kinds)) {
    const { id, title, spec } = made;
    const place = element("div", { class: "chart" });
    frame.append(element("figure", { "data-chart": id }, element("figcaption", {}, title), place, numbersOf(made, scene, kind, lines)));
    vegaEmbed(place, spec, { actions, renderer: "svg", downloadFileName: `${scene.id}-${id}`, tooltip: { theme: isDark ? "dark" : "light" } })
      .then(() => place.querySelector("summary").setAttribute("aria-label", `Save: ${title}`));
  }
}

// What of a section depends on the kind of error: its table and its charts.
function showKind(section, page, kind, place) {
  const shown = [];
  const table = section.tables?.[kind.id] ?? section.table;
  if (table) shown.push(tableFrame(table, page.lines));
  if (section.runs) shown.push(element("div", { class: "charts" }));
  place.replaceChildren(...shown);
  if (section.runs) drawCharts(section, page, kind, shown.at(-1));
}

// The frame of a section, which waits to be drawn.
function frameOf(section) {
  const heading = element("h2", {}, section.title);
  if (section.name) heading.append(" ", element("code", {}, section.name));
  const place = element(section.folded ? "details" : "div", { class: "waiting" });
  return { place, whole: element("section", { id: section.id }, heading,
    ...section.paragraphs.map((text) => element("p", {}, text)), place) };
}

// Scenes are reached from the map.
function link(section) {
  if (section.runs && !section.parameter) return;
  document.querySelector("nav").append(element("a", { href: `#${section.id}` }, section.title));
}

// The controls name a norm and a scale; both together are a kind of error.
function chosenKind(kinds) {
  const [norm, scale] = ["norm", "scale"].map((name) => document.getElementById(name).value);
  return kinds.find((kind) => kind.norm === norm && kind.scale === scale);
}

const data = JSON.parse(document.getElementById("data").textContent);
document.getElementById("sessions").append(tableFrame(data.sessions, data.lines));

// Sections are drawn as they come near the window, all of them for print, and anew for another kind of error.
const frames = data.sections.map((section) => ({ section, ...frameOf(section) }));
document.querySelector("main").append(...frames.map(({ whole }) => whole));
data.sections.forEach(link);

function draw(frame) {
  frame.place.classList.remove("waiting");
  frame.drawn = true;
  if (frame.section.folded) {
    frame.place.replaceChildren(element("summary", {}, "Show"), tableFrame(frame.section.table, data.lines));
  } else {
    showKind(frame.section, data, chosenKind(data.kinds), frame.place);
  }
}

const near = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    const frame = frames.find(({ whole }) => whole === target);
    if (isIntersecting && !frame.drawn) draw(frame);
  }
}, { rootMargin: "1000px" });
for (const { whole } of frames) near.observe(whole);
window.addEventListener("beforeprint", () => {
  frames.filter(({ drawn }) => !drawn).forEach(draw);
  for (const { section, place } of frames) if (section.folded) place.open = true;
});
for (const name of ["norm", "scale"]) {
  document.getElementById(name).addEventListener("change", () =>
    frames.filter(({ drawn, section }) => drawn && (section.tables || section.runs)).forEach(draw));
}
