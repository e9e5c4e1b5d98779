#include <fmt/format.h>

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
std::string session_note(const PageInput& page, const Choice& choice) {
  return page.results.sessions.size() > 1 ? fmt::format(", session {}", choice.session + 1) : "";
}

Cell answer(const PageInput& page, const SceneSettings& scene, double accuracy) {
  if (const auto ranked = cheapest(page.runs, scene, accuracy); !ranked.empty()) {
    const Choice& first = ranked.front();
    const std::string label = page.label(first);
    return {.text = label, .detail = describe(first) + session_note(page, first), .line = label};
  }
  const auto missed = shortfall(page.runs, scene, accuracy);
  if (!missed) return {.text = "no run finished"};
  Cell cell{.text = "none measured reaches it",
            .detail = fmt::format("Best: {}, {}{}.", page.label(missed->best), describe(missed->best),
                                  session_note(page, missed->best))};
  if (missed->needed) cell.detail += fmt::format(" {}.", describe(*missed->needed));
  return cell;
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
      .paragraphs = {"For each scene and each error at the end of the interval, the measured run that gets "
                     "there in the least time. Nothing between the measured step counts is interpolated. "
                     "An error is the largest absolute one of the scene's columns; a time is the least of "
                     "the repeats, of the solve alone."},
      .table = {.caption = "The cheapest measured run by scene and error at the end",
                .columns = {{"scene"}}}};
  if (page.results.sessions.size() > 1) {
    section.paragraphs.emplace_back(
        "The results were made in several sessions; times of different machines or builds do not "
        "compare. A run made more than once counts with its last session.");
  }
  for (const double accuracy : accuracies) section.table.columns.push_back({accuracy_text(accuracy)});
  RowGroup rows;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const SceneSettings& scene = runs.front().key.scene;
    std::vector<Cell> cells{{.text = name_of_scene(scene).title, .detail = label_of(scene)}};
    for (const double accuracy : accuracies) cells.push_back(answer(page, scene, accuracy));
    rows.rows.push_back(std::move(cells));
  }
  if (!rows.rows.empty()) section.table.groups.push_back(std::move(rows));
  return section;
}

Table sessions_table(const PageInput& page) {
  const auto& sessions = page.results.sessions;
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
