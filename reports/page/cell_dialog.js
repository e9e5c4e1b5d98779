// SPDX-License-Identifier: MIT
// What a map's cell is about, in full: names, numbers, a command to copy, the way to the scene. One dialog shows the cell that was chosen
// last; Escape, its button and a click beside it close it.

let cellDialog;
function makeCellDialog() {
  const dialog = element("dialog", { id: "cell", "aria-labelledby": "cell-title" });
  dialog.addEventListener("click", ({ target }) => {
    if (target === dialog || target.closest("[data-closes]")) dialog.close();
  });
  document.body.append(dialog);
  return dialog;
}

const factsSaid = (rows, facts) => rows.map(([name, template]) => [name, say(template, facts)]).filter(([, text]) => text);

// opened: the templates of a column of section_tables.js.
function openCell({ facts, line }, opened, to, lines) {
  const said = factsSaid(opened.rows, facts), command = say(opened.command, facts), name = say(opened.line, facts);
  cellDialog ??= makeCellDialog();
  cellDialog.replaceChildren(element("div", {},
    element("h2", { id: "cell-title" }, ...breakable(say(opened.title, facts))), element("p", {}, say(opened.about, facts)),
    ...(name ? [element("p", { class: "name" }, ...(line ? [swatch(lines, line)] : []), ...breakable(name))] : []),
    element("dl", {}, ...said.flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, ...unbroken(text))])),
    ...(command ? [commandLine(command)] : []),
    element("p", { class: "ways" }, ...(to ? [element("a", { href: `#${to}`, "data-closes": "" }, "Go to this scene")] : []),
      element("button", { type: "button", "data-closes": "" }, "Close"))));
  cellDialog.showModal();
}
