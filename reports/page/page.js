// SPDX-License-Identifier: MIT
// Builds the page from its data: sections with paragraphs, charts and tables. Facts arrive as numbers and names.

// The chart's table, made when it is opened, and its numbers as a file.
function numbersOf(chart, section, kind, lines) {
  const titles = { error: titleOfKind(kind), value: section.parameter, ...chart.titles };
  const save = element("a", { download: `${section.id}-${chart.id}.csv`, href: "" }, "CSV");
  save.addEventListener("click", () => save.setAttribute("href", `data:text/csv;charset=utf-8,${encodeURIComponent(csvOf(chart, titles))}`));
  const details = element("details", { class: "numbers" }, element("summary", {}, "Numbers"));
  details.addEventListener("toggle", () => {
    if (details.open && details.children.length === 1) details.append(save, tableFrame(numbersTable(chart, titles, (point) => openPoint(chart, point, lines)), lines));
  });
  details.open = Boolean(chart.open);
  return details;
}

const openPoint = (chart, point, lines) => openCell(chart.opens(point), openedMember, undefined, lines);

// What is made; where it fails a sentence in its place, so that the rest of the page is drawn.
const cannotBeDrawn = (what) => element("p", { class: "missing" }, `${what} cannot be drawn.`);
function apart(what, make) {
  try {
    return make();
  } catch (error) {
    console.error(error);
    return [cannotBeDrawn(what)];
  }
}

// The page draws its charts again where the window's width changes; Vega need not listen for that too.
const asWideAs = (place, spec) => (spec.width === "container" ? { ...spec, width: place.clientWidth } : spec);

// Charts listen to the document; those that have left the page are let go.
let embedded = [];
function keepWhileShown(place, finalize) {
  for (const gone of embedded.filter((chart) => !chart.place.isConnected)) gone.finalize();
  embedded = [...embedded.filter((chart) => chart.place.isConnected), { place, finalize }];
}

function drawCharts(scene, charts, { lines }, kind, frame) {
  const actions = { export: true, source: false, compiled: false, editor: false };
  for (const made of charts) {
    const { id, title, spec, note, opens } = made;
    const place = element("div", { class: "chart" });
    frame.append(element("figure", { "data-chart": id }, element("figcaption", {}, title), place, ...(note ? [element("p", { class: "key" }, note)] : []), numbersOf(made, scene, kind, lines)));
    chartLibrary().then(() => vegaEmbed(place, asWideAs(place, spec), { actions, renderer: "svg", downloadFileName: `${scene.id}-${id}`, tooltip: { theme: isDark ? "dark" : "light" } }))
      .then(({ view, finalize }) => {
        keepWhileShown(place, finalize);
        place.querySelector("summary").setAttribute("aria-label", `Save: ${title}`);
        if (opens) view.addEventListener("click", (_, item) => made.points[item?.datum?.index] && openPoint(made, made.points[item.datum.index], lines));
      })
      .catch((error) => {
        console.error(error);
        place.replaceChildren(cannotBeDrawn("This chart"));
      });
  }
}

// The charts of a section in a frame, which are as wide as it is on the page; nothing where it has none.
function framedCharts(section, page, kind, charts) {
  const frame = element("div", { class: "charts" });
  drawCharts(section, charts, page, kind, frame);
  return charts.length > 0 ? [frame] : [];
}

// What a scene is: its equations, parameters and solution.
function showScene(section, page, place) {
  const equations = () => [element("div", { class: "frame equations", role: "region", tabindex: "0", "aria-label": "Equation" }, ...section.equations.map(equation))];
  const parameters = () => [element("details", { class: "numbers" }, element("summary", {}, "Parameters"), tableFrame(parametersTable(section), page.lines))];
  if (section.equations) place.append(...apart("The equation", equations));
  if (section.parameters) place.append(...apart("The parameters", parameters));
  place.append(...apart("The solution", () => framedCharts(section, page, {}, chartsOfSolution(section))));
}

function shownTable(section, page, kind) {
  const table = tableOf(section, kind, page.sections), now = table && viewed(table, viewNow(), page.sections);
  if (!table || table.groups.every(({ rows }) => rows.length === 0)) return [];
  const countOf = ({ groups }) => groups.reduce((sum, { rows }) => sum + rows.length, 0), [left, all] = [now, table].map(countOf);
  const said = left < all && !table.map && section.groups ? [element("p", { class: "left" }, `The table has ${left} of its ${all} rows; what is said above is of all.`)] : [];
  return [...said, tableFrame(now, page.lines), ...(table.map ? keyOf(now) : [])];
}

function shownVerdicts(section, page, kind) {
  const verdicts = verdictsViewed(section, tableOf(section, kind, page.sections), kind, viewNow(), page.sections);
  const part = (title, id, of) => (of.length > 0 ? [element("h3", {}, title), linesSaid(of, page.lines, id)] : []);
  return [...part("Each scheme: where it wins, where not to use it", "winners", verdicts.filter(({ won }) => won > 0)),
    ...part(isPart(viewNow()) ? "Schemes that win none of these cells" : "Schemes that are cheapest nowhere", "others", verdicts.filter(({ won }) => won === 0))];
}

// Charts of many lines begin with the first of them, unless schemes are chosen.
function shownCharts(section, page, kind, redraw) {
  const { solution, ...measured } = section, view = viewNow();
  const wants = (line, session) => wantsLine(view, line) && wantsSession(view, session);
  const charts = (first_lines) => framedCharts(section, page, kind, chartsOfSection({ ...measured, first_lines }, page.lines, kind, page.kinds, wants));
  const all = section.runs && !view.schemes ? linesByTime(wantedPoints(section, kind, page.kinds, wants)) : [];
  if (all.length <= mostLines) return charts();
  const turn = buttonFor(() => {
    section.all_lines = !section.all_lines;
    redraw();
  }, {}, section.all_lines ? `Only the ${firstLines}` : `All ${all.length}`);
  const said = section.all_lines ? `All ${all.length} lines are drawn.` : `The charts show ${firstLines} of ${all.length} lines: those that are the quickest most often, then those nearest to them.`;
  return [element("p", { class: "left" }, said, " ", turn), ...charts(section.all_lines ? undefined : all.slice(0, firstLines))];
}

const conclusionSaid = (text) => element("p", { class: "conclusion" }, ...unbroken(text));

// Of a family: which scheme is the cheapest where, and which to take without knowing.
function familySaid(section, kind, view) {
  const of = robustnessOf(section, kind, accuracyOfFamily(section, kind, view)), rows = of?.rows ?? [];
  const winners = rows.filter(({ first }) => first).sort((a, b) => b.first - a.first).map((row) => ({ ...row, share: row.first / of.members }));
  const facts = { ...of, parameters: section.plane.parameters, kind, winners: winners.slice(0, 4), rest: winners.length - 4 > 0 && winners.length - 4, all: of.best?.solved === of.scenes };
  const shareOf = (count) => count > 0 && count / of.members;
  return say(statements.family, { ...facts, title: section.scene, tied: shareOf(of.tied), unsolved: shareOf(of.unsolved), solved: of.best && of.best.solved / of.members });
}

// A family's own part, what it says being at the top: the map with its controls, the robustness of the schemes.
function showFamily(section, page, kind, place) {
  const view = viewNow(), accuracy = accuracyOfFamily(section, kind, view);
  section.chosen ??= firstPlane(section);
  const choose = (chosen, name) => {
    section.chosen = chosen;
    showFamily(section, page, kind, place);
    place.querySelector(`.plane [name="${name}"]`)?.focus();
  };
  const map = () => framedCharts(section, page, kind, [winnerMap(section, page.lines, kind, view, section.chosen, (line, session) => wantsLine(view, line) && wantsSession(view, session))]);
  const rows = (robustnessOf(section, kind, accuracy)?.rows ?? []).filter(({ line }) => wantsLine(view, line));
  const table = () => (rows.length === 0 ? [] : [tableFrame(tableOfFacts(sectionTables.family, [{ rows }], { ...section, kind, accuracy }), page.lines)]);
  place.replaceChildren(planeControls(section, section.chosen, choose),
    ...apart("The map", map), ...apart("The table", table));
}

// What of a section depends on the kind of error: its conclusion, its table and its charts.
function showKind(section, page, kind, place) {
  if (section.plane) return showFamily(section, page, kind, place);
  const view = viewNow(), { accuracy, machine, schemes } = view;
  const families = () => (section.id === "answer" ? page.sections.filter((of) => of.plane && wantsScene(view, of)) : []).map((of) => {
    const said = conclusionSaid(familySaid(of, kind, view));
    said.append(" ", element("a", { href: `#${of.id}` }, "Its map"));
    return said;
  });
  const conclusion = () => [say(statements.conclusion, section.conclusions?.[kind.id])].filter(Boolean)
    .map((text) => element("p", { class: "conclusion" }, ...(accuracy || machine || schemes ? [element("small", {}, "Of all runs, whatever is chosen above:")] : []), ...unbroken(text)));
  const none = section.runs && !wantsRuns(view, section) ? [element("p", { class: "left" }, ...leftSaid("None of the chosen runs is of this scene."))] : [];
  place.replaceChildren(...apart("What is said of families", families), ...apart("The conclusion", conclusion),
    ...apart("The table", () => shownTable(section, page, kind)),
    ...(section.schemes ? apart("What is said of each scheme", () => shownVerdicts(section, page, kind)) : []),
    ...none, ...apart("The charts", () => shownCharts(section, page, kind, () => showKind(section, page, kind, place))));
}

// A phone shows the answer, and of the other sections their headings until they are opened.
const isNarrow = matchMedia("(max-width: 46rem)").matches;

// The frame of a section, which waits to be drawn.
function frameOf(section) {
  const heading = element("h2", {}, section.title);
  if (section.name) heading.append(" ", element("code", {}, section.name));
  const [place, scene] = [element("div", { class: "waiting" }), element("div", { class: "scene" })];
  const paragraphs = (texts) => saidOfSection(section, texts).map((text) => element("p", {}, text));
  const details = element("details", {}, element("summary", {}, heading), ...paragraphs("paragraphs"), scene, place, ...paragraphs("notes"));
  details.open = !isNarrow && !textsOf(section).folded;
  return { place, scene, details, whole: element("section", { id: section.id }, details) };
}

// Scenes are reached from the map.
function link(section) {
  if (section.runs && !section.parameter) return null;
  const made = element("a", { href: `#${section.id}` }, textsOf(section).brief ?? section.title);
  document.querySelector("nav").append(made);
  return made;
}

// The controls name a norm and a scale; both together are a kind of error.
function chosenKind(kinds) {
  const [norm, scale] = ["norm", "scale"].map((name) => document.getElementById(name).value);
  return kinds.find((kind) => kind.norm === norm && kind.scale === scale);
}

// The page's data, and the frames of its sections.
let data, frames = [];

// What sections have of others: titles, drifts, sessions, solutions.
function completeData() {
  const { sections } = data;
  for (const section of sections) section.title = say(textsOf(section).title, section);
  // The drifts of a scene's formulations stand where its runs are.
  for (const drift of sections.flatMap(({ drifts }) => drifts ?? [])) {
    const scene = sections.find(({ id, runs }) => runs && id === drift.id);
    if (scene) scene.drifts = [drift];
  }
  for (const section of sections.filter(({ drifts, runs }) => drifts && !runs)) {
    section.drifts = section.drifts.filter(({ id }) => !sections.some((other) => other.runs && other.id === id));
  }
  const made = data.sessions.map(({ machine, date, commit }) => ({ machine, date, commit }));
  for (const section of sections.filter(({ runs }) => runs)) section.made = made;
  for (const section of sections.filter(({ solution }) => solution?.of)) section.solution = sections.find(({ id }) => id === section.solution.of).solution;
}

function draw(frame) {
  frame.place.classList.remove("waiting");
  frame.drawn = true;
  if (!frame.scene.hasChildNodes()) showScene(frame.section, data, frame.scene);
  showKind(frame.section, data, chosenKind(data.kinds), frame.place);
}

function openSection(frame) {
  frame.details.open = true;
  if (!frame.drawn) draw(frame);
}
const drawAll = () => frames.filter(({ whole }) => !whole.hidden).forEach(openSection);

// Hidden or closed, a chart has no width; the section waits until it is shown again.
function setAside(frame) {
  frame.place.replaceChildren();
  frame.place.classList.add("waiting");
  frame.drawn = false;
}

// Sections are drawn as they come near the window, all of them for print, and again for another kind of error.
function drawAsSeen() {
  const near = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      const frame = frames.find(({ whole }) => whole === target);
      if (isIntersecting && frame.details.open && !frame.drawn) draw(frame);
    }
  }, { rootMargin: "1000px" });
  for (const frame of frames) {
    near.observe(frame.whole);
    frame.details.addEventListener("toggle", () => {
      if (!frame.details.open) setAside(frame);
      near.unobserve(frame.whole);  // observed anew it is looked at once
      near.observe(frame.whole);
    });
  }
  window.addEventListener("beforeprint", drawAll);
}

// Whatever is drawn is drawn again for another view; sections without anything that it wants are hidden.
function show() {
  const view = viewNow();
  for (const frame of frames) {
    frame.whole.hidden = !hasContent(view, frame.section, chosenKind(data.kinds), data.sections);
    if (frame.link) frame.link.hidden = frame.whole.hidden;
    if (frame.drawn && (frame.whole.hidden || !frame.details.open)) setAside(frame);
  }
  sayWhatIsShown(view, data.sections);
  frames.filter(({ drawn }) => drawn).forEach(draw);
}

// The place that the address leads to, which stays at the top while sections above it are drawn, until the reader does something.
let placeShown;
function goToPlace() {
  placeShown = document.getElementById(addressOf().place);
  const frame = frames.find(({ whole }) => !whole.hidden && whole.contains(placeShown));
  if (frame) openSection(frame);
  placeShown?.scrollIntoView();
}
function keepPlace() {
  new ResizeObserver(() => placeShown?.scrollIntoView()).observe(document.querySelector("main"));
  for (const done of ["wheel", "touchstart", "pointerdown", "keydown"]) window.addEventListener(done, () => { placeShown = null; }, { passive: true });
}

function followControls() {
  document.getElementById("view").addEventListener("change", () => {
    writeAddress();
    sayHowManySchemes();
    show();
  });
  document.getElementById("view").addEventListener("submit", (event) => event.preventDefault());
  window.addEventListener("hashchange", () => {
    if (location.hash.includes("?")) {
      readAddress();
      show();
    } else {
      writeAddress();
    }
    goToPlace();
  });
  let width = innerWidth;
  window.addEventListener("resize", () => {
    if (innerWidth === width) return;
    width = innerWidth;
    show();
  });
}

async function openPage() {
  data = JSON.parse(await unpacked("data"));
  completeData();
  document.getElementById("sessions").append(tableFrame(sessionsTable(data.sessions), data.lines));
  frames = data.sections.map((section) => ({ section, link: link(section), ...frameOf(section) }));
  document.querySelector("main").append(...frames.map(({ whole }) => whole));
  drawAsSeen();
  offerSchemes(data.lines);
  offerMachines(data.sessions.map(({ machine }) => machine));
  readAddress();
  if (frames.length > 0) {  // the answer is shown wherever the address leads to
    frames[0].details.open = true;
    frames[0].drawn = true;
  }
  show();
  if (addressOf().view.has("all")) drawAll();
  goToPlace();
  keepPlace();
  followControls();
  document.querySelector("main").removeAttribute("aria-busy");
}

if (typeof DecompressionStream !== "undefined") openPage();
