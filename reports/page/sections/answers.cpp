#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/text.hpp"
#include "page/page_data.hpp"

namespace fde {
namespace {

constexpr std::array accuracies{1e-2, 1e-4, 1e-6, 1e-8};

std::string accuracy_text(double accuracy) { return fmt::format("error ≤ 1e{:.0f}", std::log10(accuracy)); }

// Times of different sessions may come from different machines: say whose they are.
std::string session_note(const PageInput& page, const Option& option) {
  return page.sessions.size() > 1 ? fmt::format(", session {}", option.session + 1) : "";
}

// The other names of one algorithm.
std::string names_note(const Option& option) {
  if (option.schemes.size() < 2) return "";
  return fmt::format("; here the same as {}",
                     fmt::join(option.schemes.begin() + 1, option.schemes.end(), ", "));
}

// Lines whose time meets that of the first.
std::string noise_note(const PageInput& page, const std::vector<Option>& ranked) {
  std::vector<std::string> names;
  for (const Option& option : ranked) {
    if (&option != &ranked.front() && option.time.low <= ranked.front().time.high)
      names.push_back(page.label(option));
  }
  return names.empty() ? "" : fmt::format("; within noise of {}", fmt::join(names, ", "));
}

Cell answer(const PageInput& page, const SceneSettings& scene, const ErrorKind& kind, double accuracy) {
  if (const auto ranked = options_within(page.runs, scene, kind, accuracy); !ranked.empty()) {
    const Option& first = ranked.front();
    const std::string label = page.label(first);
    return {
        .text = label,
        .detail = run_text(first) + names_note(first) + session_note(page, first) + noise_note(page, ranked),
        .line = label};
  }
  const auto missed = shortfall(page.runs, scene, kind, accuracy);
  if (!missed) return {.text = "no run has this error"};
  Cell cell{.text = missed->untimed > 0 ? "reached, not timed yet" : "none measured reaches it",
            .detail = fmt::format("Best: {}, {}{}.", page.label(missed->best), run_text(missed->best),
                                  session_note(page, missed->best))};
  if (missed->steps_needed)
    cell.detail += fmt::format(" {}.", needed_text(page.label(missed->line), *missed->steps_needed));
  return cell;
}

Table answers_table(const PageInput& page, const ErrorKind& kind) {
  Table table{.caption = fmt::format("The cheapest measured run by scene and {}", error_title(kind)),
              .columns = {{"scene"}}};
  for (const double accuracy : accuracies) table.columns.push_back({accuracy_text(accuracy)});
  RowGroup rows;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const SceneSettings& scene = runs.front().key.scene;
    std::vector<Cell> cells{{.text = name_of_scene(scene).title, .detail = label_of(scene)}};
    for (const double accuracy : accuracies) cells.push_back(answer(page, scene, kind, accuracy));
    rows.rows.push_back(std::move(cells));
  }
  table.groups.push_back(std::move(rows));
  return table;
}

std::vector<Cell> row(std::string name, const std::vector<Session>& sessions,
                      std::string (*text)(const Session&)) {
  std::vector<Cell> cells{{.text = std::move(name)}};
  for (const Session& session : sessions) cells.push_back({.text = text(session)});
  return cells;
}

}  // namespace

Section answers_section(const PageInput& page) {
  Section section{
      .id = "answer",
      .title = "Which scheme is cheapest",
      .paragraphs = {
          "For each scene and each error, the measured run that gets there in the least time. Nothing "
          "between the measured step counts is interpolated. No run counts that y = 0 or y = y(0) "
          "would match. The error is the largest over the scene's columns, on the scale chosen "
          "above; a time is the median of the repeats with its 95 % interval, of the solve alone."}};
  if (page.sessions.size() > 1) {
    section.paragraphs.emplace_back(
        "The results were made in several sessions; times of different machines or builds do not "
        "compare. A run made more than once counts with its last session.");
  }
  if (page.runs.finished.empty()) return section;
  for (const ErrorKind& kind : error_kinds()) section.tables.push_back(answers_table(page, kind));
  return section;
}

Table sessions_table(const PageInput& page) {
  const auto& sessions = page.sessions;
  Table table{.caption = "Where and with what the numbers were made", .columns = {{"session"}}};
  for (std::size_t i = 0; i < sessions.size(); ++i) table.columns.push_back({std::to_string(i + 1)});
  std::vector<std::vector<Cell>> rows{
      row("date", sessions, [](const Session& s) { return s.date; }),
      row("machine", sessions, [](const Session& s) { return s.machine; }),
      row("cores", sessions, [](const Session& s) { return s.cores > 0 ? std::to_string(s.cores) : ""; }),
      row("system", sessions, [](const Session& s) { return s.system; }),
      row("compiler", sessions, [](const Session& s) { return s.compiler; }),
      row("flags", sessions, [](const Session& s) { return s.flags; }),
      row("commit", sessions, [](const Session& s) { return s.commit; }),
      row("version", sessions, [](const Session& s) { return s.version; }),
  };
  std::erase_if(rows, [](const auto& cells) {
    return std::all_of(cells.begin() + 1, cells.end(), [](const Cell& cell) { return cell.text.empty(); });
  });
  table.groups.push_back({.rows = rows});
  return table;
}

}  // namespace fde
