// Elements of the page: texts, cells, tables.

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
const cellOf = (cell) => (typeof cell === "string" ? { text: cell } : { text: cell.line ?? "", ...cell });

function cellContent(cell, lines, painted, to) {
  const text = cell.marked ? [element("mark", {}, cell.text)] : breakable(cell.text);
  const parts = to && cell.text ? [element("a", { href: `#${to}` }, ...text)] : text;
  if (cell.line && !painted) parts.unshift(element("i", { class: "swatch", style: `background:${colourOf(lines, cell.line)}` }));
  if (cell.detail) parts.push(element("small", {}, ...unbroken(cell.detail)));
  return parts;
}

// A map's cell wears the colour of its line or its verdict; data-column repeats its heading for narrow screens, where the cells of a row wrap.
function mapAttributes(cell, column, lines) {
  const paint = cell.line ? { style: `--paint:${colourOf(lines, cell.line)};--strength:${Math.round(12 + 48 * (cell.strength ?? 0))}%` }
    : cell.tone && cell.strength ? { style: `--strength:${Math.round(8 + 34 * cell.strength)}%` } : {};
  return { "data-column": column.text, ...(cell.tone && { "data-tone": cell.tone }), ...paint };
}

// A cell of the map stands for a row of its section's table, which says more.
function hintOf(cell, column, { to }, kind) {
  if (cell.hint || !to) return cell.hint;
  const rows = data.sections.find(({ id }) => id === to)?.tables[kind.id].groups[0].rows;
  const row = rows?.find(([heading]) => cellOf(heading).text === column.text);
  return row?.slice(1).map((of) => cellOf(of).text).filter(Boolean).join(": ");
}

function tableRow(row, { columns, map }, lines) {
  const cells = row.map(cellOf);
  return element("tr", {}, ...cells.map((cell, i) => {
    const hint = hintOf(cell, columns[i], cells[0], chosenKind(data.kinds));
    const attributes = { ...(hint && { title: hint }), ...(cell.faint && { class: "faint" }), ...(map && i > 0 && mapAttributes(cell, columns[i], lines)) };
    return element(i ? "td" : "th", i ? attributes : { scope: "row" }, ...cellContent(cell, lines, map, map || i === 0 ? cells[0].to : undefined));
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

