// SPDX-License-Identifier: MIT
// Elements of the page: texts, cells, tables.

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function buttonFor(action, attributes, ...children) {
  const button = element("button", { type: "button", ...attributes }, ...children);
  button.addEventListener("click", action);
  return button;
}

// Ids may break behind their underscores, labels behind each setting.
const breakable = (text) => text.split(/(?<=[_,:])/).flatMap((part, i) => (i ? [element("wbr"), part] : [part]));

// Step counts, times and numbers like 1.2e-7 may not break.
const unbroken = (text) => text.split(/([Nt] = [^\s,]+|\S+e-\d+)/).map((part, i) => (i % 2 ? element("span", {}, part) : part));

// The colour and the shape that a line's points have in the charts.
const swatch = (lines, line) => element("i", { class: "swatch", "data-shape": shapeOf(lines, line), style: `background:${colourOf(lines, line)}` });

// What a verdict is in a map of narrow cells; one that is not here is shown by its id.
const signs = { survives: "✓", "stops rightly": "✓", inaccurate: "≈", fails: "✗", refuses: "–", "not judged": "?" };

// Of a map's cell: a line and a time, or the sign of a verdict, which a screen reader says in words, and an error.
function mapContent(cell, { opened }, to, lines) {
  const sign = cell.line ?? signs[cell.tone] ?? cell.tone ?? "";
  const detail = cell.short ?? cell.detail ?? (sign ? "" : cell.text);
  const parts = [...(sign ? [element("b", {}, ...breakable(sign))] : []), ...(sign && detail ? [" "] : []), ...(detail ? [element("small", {}, ...unbroken(detail))] : [])];
  if (!opened.of.some((name) => name in cell.facts)) return parts;
  const label = [...new Set([[sign, detail].filter(Boolean).join(" "), ...(cell.line ? [] : [cell.text])].filter(Boolean))].join(": ");
  return [buttonFor(() => openCell(cell, opened, to, lines), { "aria-haspopup": "dialog", "aria-label": label }, ...parts)];
}

// A command line, and a button that copies it.
function commandLine(text) {
  const code = element("code", {}, text);
  const button = buttonFor(async () => {
    try {
      await navigator.clipboard.writeText(text);
    } catch { // no clipboard for pages of files
      getSelection().selectAllChildren(code);
      document.execCommand("copy");
    }
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  }, { "aria-label": `Copy: ${text}` }, "Copy");
  return element("span", { class: "command" }, code, button);
}

function cellContent(cell, lines, to) {
  const text = cell.marked ? [element("mark", {}, cell.text)] : breakable(cell.text);
  const parts = to && cell.text ? [element("a", { href: `#${to}` }, ...text)] : cell.opens ? [buttonFor(cell.opens, { "aria-haspopup": "dialog" }, ...text)] : text;
  if (cell.line) parts.unshift(swatch(lines, cell.line));
  if (cell.detail) parts.push(element("small", {}, ...unbroken(cell.detail)));
  if (cell.command) parts.push(commandLine(cell.command));
  return parts;
}

// Of the colour in a map, in [0, 1]. A line: 0 where another may be as quick, 1 where the second takes ten times as long or there is none.
const strengthOfLine = ({ ties, second }) => (ties ? 0 : second ? Math.min(1, Math.max(0, Math.log10(second.ratio))) : 1);
// A run that survives: the digits that agree, of 16.
const strengthOfError = ({ verdict, error }) => (verdict === "survives" && error !== undefined ? Math.min(1, -Math.log10(Math.max(error, 1e-16)) / 16) : undefined);

const percentOfLine = (facts) => 12 + 48 * strengthOfLine(facts);

// A map's cell wears the colour of its line or its verdict; data-column repeats its heading for narrow screens, where the cells of a row wrap.
function mapAttributes(cell, column, lines) {
  const strength = cell.line ? percentOfLine(cell.facts) : 8 + 34 * strengthOfError(cell.facts);
  const style = [...(cell.line ? [`--paint:${colourOf(lines, cell.line)}`] : []), ...(strength ? [`--strength:${Math.round(strength)}%`] : [])].join(";");
  const paint = style ? { style } : {};
  return { "data-column": column.text, ...(cell.tone && { "data-tone": cell.tone }), ...paint };
}

// A scene that differs from the one above in its settings alone is named by these.
function shortHeading(text, above) {
  const [base, settings] = text.split(" (");
  return settings && above?.split(" (")[0] === base ? settings.replace(")", "") : text;
}

function tableRow(row, { columns, map }, lines, above) {
  const cells = [...row];
  if (map) {
    const text = shortHeading(cells[0].text, above?.[0].text);
    if (text !== cells[0].text) cells[0] = { ...cells[0], text, hint: cells[0].text, variant: true };
  }
  return element("tr", {}, ...cells.map((cell, i) => {
    const marks = ["faint", "variant"].filter((mark) => cell[mark]).join(" ");
    const attributes = { ...(cell.hint && { title: cell.hint }), ...(marks && { class: marks }), ...(map && i > 0 && mapAttributes(cell, columns[i], lines)) };
    return element(i ? "td" : "th", i ? attributes : { scope: "row", ...attributes }, ...(map && i ? mapContent(cell, columns[i], cells[0].to, lines) : cellContent(cell, lines, map || i === 0 ? cells[0].to : undefined)));
  }));
}

function tableGroup(group, table, lines) {
  const { columns } = table;
  const rows = group.rows.map((row, i) => tableRow(row, table, lines, group.rows[i - 1]));
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

function tableHead({ columns }) {
  const row = element("tr", {}, ...columns.map((column) => element("th", { scope: "col" }, ...breakable(column.text))));
  if (!columns.some((column) => column.over)) return element("thead", {}, row);
  return element("thead", {}, element("tr", {}, ...sharedHeadings(columns)), row);
}

// A table in a frame of its own, which scrolls where the screen is narrower.
function tableFrame(table, lines) {
  return element("div", { class: "frame", role: "region", tabindex: "0", "aria-label": table.caption },
    element("table", table.map ? { class: "map" } : {}, element("caption", {}, table.caption), tableHead(table),
      ...table.groups.map((group) => tableGroup(group, table, lines))));
}

// What the strength of a cell's colour means, where the colours are those of lines.
function keyOf({ groups }) {
  if (!groups.some(({ rows }) => rows.some((row) => row.some(({ line }) => line)))) return [];
  const chip = ([ratio, text]) => element("b", { style: `--strength:${Math.round(percentOfLine({ second: { ratio } }))}%` }, text);
  return [element("p", { class: "key" }, "Each scheme has its colour. The next scheme takes ", ...[[1, "as long"], [3, "3 times as long"], [10, "10 times or more, or never gets there"]].flatMap((of) => [" ", chip(of)]))];
}

// What is said of each line.
function linesSaid(verdicts, lines, id) {
  return element("dl", { class: "said", id }, ...verdicts.map(({ line, texts }) => element("div", {},
    element("dt", {}, swatch(lines, line), ...breakable(line)),
    ...texts.filter(Boolean).map((text) => element("dd", {}, ...unbroken(text[0].toUpperCase() + text.slice(1)))),
  )));
}
