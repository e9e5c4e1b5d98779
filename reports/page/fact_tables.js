// SPDX-License-Identifier: MIT
// Tables of texts, made of rows of facts and the columns of section_tables.js.

// The texts of a cell that its column has and that are not empty; the facts go with them.
const textsOfCell = ["cell", "detail", "short", "hint", "line", "marked", "to", "tone", "command"];
function cellOfFacts(column, facts) {
  const texts = textsOfCell.filter((name) => column[name]).map((name) => [name, say(column[name], facts)]).filter(([, text]) => text);
  return { text: "", facts, ...Object.fromEntries(texts.map(([name, text]) => [name === "cell" ? "text" : name, text])) };
}

// A column for each element of its list, { ...column, each, place }.
const spread = (columns, section) => columns.flatMap((column) => (column.each ? section[column.each].map((each, place) => ({ ...column, each, place })) : [column]));

// Columns that say nothing in any row are left out.
function tableOfFacts({ caption, columns, group = "{title}", map, filter, fades }, groups, section) {
  const all = spread(columns, section);
  const rowOf = (row) => all.map((column) =>
    cellOfFacts(column, column.place === undefined ? { ...row, section } : { ...row.cells[column.place], each: column.each, row, section }));
  const shown = groups.map((facts) => ({ title: say(group, facts), rows: facts.rows.map(rowOf) }));
  const kept = all.map((_, i) => i).filter((i) => shown.some(({ rows }) => rows.some((row) => row[i].text)));
  return {
    caption: say(caption, section), map, filter, fades,
    columns: kept.map((i) => ({ text: say(all[i].head, { ...section, each: all[i].each }), over: all[i].over, each: all[i].each, opened: all[i].opened })),
    groups: shown.map(({ title, rows }) => ({ title, rows: rows.map((row) => kept.map((i) => row[i])) })),
  };
}

// The rows of a section for a kind of error: its own, the answers of its scene, or in the map those of all scenes.
function groupsOf(section, kind, sections) {
  if (section.id !== "answer") return section.groups?.[kind.id] ?? section.groups ?? (section.answers ? [{ rows: section.answers[kind.id] }] : null);
  return [{ rows: sections.filter(({ answers }) => answers).map(({ id, title, name, answers }) => ({ id, title, name, cells: answers[kind.id] })) }];
}

// The table of a section for a kind of error, made once; null where it has none.
const tablesMade = new Map();
function tableOf(section, kind, sections) {
  const key = `${section.id} ${kind.id}`;
  if (!tablesMade.has(key)) {
    const groups = groupsOf(section, kind, sections);
    tablesMade.set(key, groups && tableOfFacts(sectionTables[section.id] ?? sectionTables.scene, groups, { ...section, kind }));
  }
  return tablesMade.get(key);
}

const parametersTable = ({ parameters }) => tableOfFacts(sectionTables.parameters, [{ rows: parameters }], {});

// Properties down, sessions across.
function sessionsTable(sessions) {
  const rows = sectionTables.sessions.properties.map((property) => ({ property, cells: sessions.map((session) => ({ text: session[property] })) }));
  const known = rows.filter(({ cells }) => cells.some(({ text }) => !isMissing(text)));
  return tableOfFacts(sectionTables.sessions, [{ rows: known }], { numbers: sessions.map((_, i) => i + 1) });
}
