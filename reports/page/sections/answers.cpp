// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "fdebench/reports/analysis/recommendation.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/accuracies.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

std::string accuracy_text(double accuracy) { return fmt::format("≤ 1e{:.0f}", std::log10(accuracy)); }

// The session of a time, if there are several: they may be from different machines.
std::string session_note(const PageInput& page, const RecommendedRun& option) {
  return page.sessions.size() > 1 ? fmt::format(", session {}", option.session + 1) : "";
}

// The other schemes that are the same algorithm on this scene.
std::string names_note(const RecommendedRun& option) {
  if (option.schemes.size() < 2) return "";
  return fmt::format("here the same as {}",
                     fmt::join(option.schemes.begin() + 1, option.schemes.end(), ", "));
}

// The distance of the other lines from the quickest one.
struct Margin {
  double ratio = 1.0;               // time of the second line / time of the first
  std::vector<std::string> ties{};  // lines whose time interval overlaps the first's
};

Margin margin_of(const PageInput& page, std::span<const RecommendedRun> ranked) {
  Margin margin;
  const RecommendedRun& first = ranked.front();
  for (const RecommendedRun& other : ranked.subspan(1)) {
    if (other.time.low <= first.time.high) margin.ties.push_back(page.label(other));
  }
  if (ranked.size() > 1) margin.ratio = ranked[1].time.median / first.time.median;
  return margin;
}

// The first few names, and the number of further names.
std::string first_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  const std::span first(names.data(), std::min(names.size(), most));
  const auto more = names.size() - first.size();
  return fmt::format("{}{}", fmt::join(first, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

// A text with the smallest error of other algorithms than the first.
std::string next_best(const PageInput& page, const SceneSettings& scene, const RecommendedRun& first,
                      const ErrorKind& kind) {
  const MeasuredRun* next = nullptr;
  const auto measure = error_measure(kind);
  for (const MeasuredRun& run : of_scene(page.runs.finished, scene)) {
    if (!run[measure] || std::ranges::count(first.schemes, run.key.scheme) > 0) continue;
    if (next == nullptr || *run[measure] < *(*next)[measure]) next = &run;
  }
  if (next == nullptr) return {};
  return fmt::format("; the next best, {}, has {}", page.label(next->key), error_text(*(*next)[measure]));
}

std::string margin_text(const PageInput& page, const SceneSettings& scene,
                        std::span<const RecommendedRun> ranked, const ErrorKind& kind) {
  if (ranked.size() == 1) return "no other line gets there" + next_best(page, scene, ranked.front(), kind);
  const Margin margin = margin_of(page, ranked);
  if (!margin.ties.empty()) return "within noise of " + first_names(margin.ties);
  const auto times =
      margin.ratio < 10.0 ? fmt::format("{:.1f}", margin.ratio) : rough_count_text(margin.ratio);
  return fmt::format("{} times as quick as {}: {}", times, page.label(ranked[1]),
                     reason_for_speed(page, scene, ranked[0], ranked[1], kind.norm));
}

// Strength of the winner's colour: 0 if another line may be as quick, 1 if the second takes ten times as long
// or there is no second.
double strength(const PageInput& page, std::span<const RecommendedRun> ranked) {
  if (ranked.size() == 1) return 1.0;
  const Margin margin = margin_of(page, ranked);
  return margin.ties.empty() ? std::clamp(std::log10(margin.ratio), 0.0, 1.0) : 0.0;
}

std::string run_note(const PageInput& page, const RecommendedRun& option) {
  const auto grid = page.grid(option.setup);
  return fmt::format("{}{}{}{}", grid, grid.empty() ? "" : ", ", run_text(option),
                     session_note(page, option));
}

std::string best_text(const PageInput& page, const RecommendedRun& best) {
  return fmt::format("{}, {}", page.label(best), run_note(page, best));
}

// The cell of the map if no run is within the accuracy. The tooltip shows the row of the scene's own table.
Cell missing_cell(const std::optional<Shortfall>& missed) {
  if (!missed) return {.text = "", .detail = "not measured"};
  if (missed->untimed > 0) return {.text = "", .detail = "not timed yet"};
  return {.text = "", .detail = fmt::format("best {}", error_text(missed->best.error))};
}

Cell map_cell(const PageInput& page, const SceneLines& lines, const ErrorKind& kind, double accuracy) {
  const auto ranked = lines.within(kind, accuracy);
  if (ranked.empty()) return missing_cell(lines.shortfall(kind, accuracy, {}));
  const RecommendedRun& first = ranked.front();
  return {.text = page.label(first),
          .detail = time_text(first.time.median),
          .line = page.label(first),
          .strength = strength(page, ranked),
          .runner_up_ratio = ranked.size() > 1 ? ranked[1].time.median / first.time.median : 0.0,
          .session = page.sessions.size() > 1 ? first.session + 1 : 0};
}

std::vector<Cell> answer_row(const PageInput& page, const SceneSettings& scene, const SceneLines& lines,
                             const ErrorKind& kind, std::span<const ErrorForecast> forecasts,
                             double accuracy) {
  Cell heading{.text = accuracy_text(accuracy)};
  if (const auto ranked = lines.within(kind, accuracy); !ranked.empty()) {
    const RecommendedRun& first = ranked.front();
    const std::string label = page.label(first);
    return {heading,
            {.text = label, .detail = names_note(first), .line = label},
            {.text = run_note(page, first), .command = options_of(first)},
            {.text = margin_text(page, scene, ranked, kind)}};
  }
  const auto missed = lines.shortfall(kind, accuracy, forecasts);
  if (!missed) return {heading, {.text = "no run has this error"}, {}, {}};
  std::vector<Cell> cells{
      heading,
      {.text = missed->untimed > 0 ? "reached, not timed yet" : "none measured reaches it"},
      {.text = fmt::format("best: {}", best_text(page, missed->best))},
      {}};
  if (missed->steps_needed) cells.back().text = needed_text(page.label(missed->line), *missed->steps_needed);
  return cells;
}

// One scene of the map.
struct MapRow {
  std::string title, section;
  SceneLines lines;
};

std::vector<MapRow> map_rows(const PageInput& page) {
  std::vector<MapRow> rows;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const SceneSettings& scene = runs.front().key.scene;
    rows.push_back({name_of_scene(scene).title, section_of(scene), SceneLines(page.runs, scene)});
  }
  return rows;
}

Table answers_map(const PageInput& page, const std::vector<MapRow>& scenes, const ErrorKind& kind) {
  Table table{.caption = fmt::format("The cheapest measured run by scene and {}", error_title(kind)),
              .columns = {{"scene"}},
              .is_map = true};
  for (const double accuracy : accuracies) table.columns.push_back({accuracy_text(accuracy)});
  RowGroup rows;
  for (const auto& [title, section, lines] : scenes) {
    std::vector<Cell> cells{{.text = title, .link = section}};
    for (const double accuracy : accuracies) cells.push_back(map_cell(page, lines, kind, accuracy));
    rows.rows.push_back(std::move(cells));
  }
  table.groups.push_back(std::move(rows));
  return table;
}

}  // namespace

Section answers_section(const PageInput& page) {
  Section section{
      .id = "answer",
      .title = "Which scheme is cheapest",
      .paragraphs = {"For each scene and each error, the measured run that reaches it in the least time. The "
                     "darker the cell, the larger the factor by which the next scheme is slower. A click "
                     "leads to the scene, with the runs, its "
                     "charts and its equation's source."}};
  if (page.sessions.size() > 1) {
    section.paragraphs.emplace_back(
        "The results were made in several sessions; times of different machines or builds do not "
        "compare. A run made more than once counts with its last session.");
  }
  if (page.runs.finished.empty()) return section;
  const auto scenes = map_rows(page);
  for (const ErrorKind& kind : error_kinds) section.tables.push_back(answers_map(page, scenes, kind));
  return section;
}

Table scene_answers(const PageInput& page, const SceneSettings& scene, const SceneLines& lines,
                    const ErrorKind& kind) {
  Table table{.caption = fmt::format("The cheapest measured run by {}", error_title(kind)),
              .columns = {{error_title(kind)}, {"cheapest"}, {"its run"}, {"why"}}};
  RowGroup rows;
  const auto forecasts = lines.forecasts(kind);
  for (const double accuracy : accuracies)
    rows.rows.push_back(answer_row(page, scene, lines, kind, forecasts, accuracy));
  table.groups.push_back(std::move(rows));
  return table;
}

}  // namespace fde::bench
