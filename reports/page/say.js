// SPDX-License-Identifier: MIT
// Sentences: templates filled with facts. In a template
//   {path:format}     is a fact in its format: of numberFormats, or one of statements; without one as it is. The path may lead into
//                     an object or a list, {second.line}; without a path the format is given all facts.
//   {path:format/, }  is a list whose elements stand between commas, as they do unless another text is given.
//   {?path}, {!path}  are nothing, where the fact is there, or is not; {?path=value} where it is this value.
//   [...]             is left out where a fact inside it is missing; so is a whole template.
// Of a list of templates the first that lacks nothing is said.

const isMissing = (fact) => fact === undefined || fact === null || fact === false || fact === "" || (Array.isArray(fact) && fact.length === 0);
const factAt = (facts, path) => (path ? path.split(".").reduce((of, name) => of?.[name], facts) : facts);

// A text as one word of a shell.
const shellWord = (text) => (/^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

// The formats of whole facts: the first three names, or how many there are.
const firstNames = (names) => names.slice(0, 3).join(", ") + (names.length > 3 ? ` and ${names.length - 3} more` : "");
const wholeFormats = { shell: shellWord, few: firstNames, scenes: (names) => (names.length > 3 ? `${names.length} scenes` : firstNames(names)) };

// A fact in its format; of a statement that is a table of words the id itself where it has none. null: nothing is left to say.
function formatted(fact, format, between = ", ") {
  if (wholeFormats[format]) return wholeFormats[format](fact);
  if (Array.isArray(fact)) {
    const texts = fact.map((one) => formatted(one, format)).filter((text) => text !== null);
    return texts.filter((text, i) => text !== texts[i - 1]).join(between) || null;
  }
  if (numberFormats[format]) return numberFormats[format](fact);
  const statement = statements[format];
  if (statement === undefined) return String(fact);
  return typeof fact === "object" ? said(statement, fact) : Object.hasOwn(statement, fact) ? statement[fact] : String(fact);
}

const placePattern = /^\{([?!]?)([\w.]*)(?::(\w+))?(?:\/(.*))?(?:=(\w+))?\}$/;
function placeOf(token) {
  const [, test, path, format, between, value] = placePattern.exec(token);
  return (facts) => {
    const fact = factAt(facts, path);
    if (test) return (value === undefined ? !isMissing(fact) : String(fact) === value) === (test === "?") ? "" : null;
    return isMissing(fact) ? null : formatted(fact, format, between);
  };
}

// Parts: texts, places, and lists of parts that may be left out.
function partsOf(text) {
  const open = [[]];
  for (const token of text.split(/(\{[^}]*\}|[[\]])/).filter(Boolean)) {
    if (token === "[") open.push([]);
    else if (token === "]") open.at(-2).push(open.pop());
    else open.at(-1).push(token.startsWith("{") ? placeOf(token) : token);
  }
  return open[0];
}
const parsed = new Map();
function choicesOf(template) {
  if (!parsed.has(template)) parsed.set(template, [template].flat().map(partsOf));
  return parsed.get(template);
}

function filled(parts, facts) {
  let text = "";
  for (const part of parts) {
    const piece = typeof part === "string" ? part : typeof part === "function" ? part(facts) : filled(part, facts) ?? "";
    if (piece === null) return null;
    text += piece;
  }
  return text;
}

function said(template, facts) {
  for (const parts of choicesOf(template)) {
    const text = filled(parts, facts)?.replace(/ {2,}/g, " ").trim();
    if (text) return text;
  }
  return null;
}

// The text of a template, empty where it lacks a fact.
const say = (template, facts) => (template && said(template, facts)) ?? "";
const titleOfKind = (kind) => say(statements.kind, kind);
