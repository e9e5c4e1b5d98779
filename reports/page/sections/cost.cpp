// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

Cell cell(const std::optional<double>& value, std::string (*text)(double)) {
  return {.text = value ? text(*value) : ""};
}

std::string digits_text(double digits) { return fmt::format("{:.1f}", digits); }

Cell newton(const MeasuredRun& run) {
  const auto iterations = run["newton_iterations"];
  if (!iterations) return {.text = run.key.external ? "" : "explicit"};
  return {.text = fmt::format("{} (to {})", count_text(*iterations), error_text(run.key.setup.tolerance))};
}

Cell time_cell(const MeasuredRun& run) {
  Cell shown = cell(run["time_minimum"], time_text);
  shown.text += clock_note(run.wall_clock);
  return shown;
}

std::vector<Cell> row(const PageInput& page, const MeasuredRun& run) {
  const std::string label = page.label(run.key);
  return {{.text = label, .detail = page.grid(run.key.setup), .line = label},
          {.text = count_text(run.steps)},
          time_cell(run),
          cell(run["error_end"], error_text),
          cell(run["mescd"], digits_text),
          cell(run["states"], count_text),
          cell(run["start_weights"], count_text),
          cell(run["rhs_calls"], count_text),
          newton(run),
          cell(run["history_bytes"], bytes_text)};
}

}  // namespace

Section cost_section(const PageInput& page) {
  Section section{.id = "cost",
                  .title = "Cost at the finest step count",
                  .table = {.caption = "What each scheme used at its finest step count",
                            .columns = {{"scheme"},
                                        {"N"},
                                        {"time"},
                                        {"error at the end"},
                                        {"digits (mescd)"},
                                        {"states"},
                                        {"start weights"},
                                        {"rhs calls"},
                                        {"Newton iterations"},
                                        {"history"}}}};
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    RowGroup group{.title = name_of_scene(scene.front().key.scene).title};
    for (const RunSpan line : by_line(scene)) group.rows.push_back(row(page, line.back()));
    section.table.groups.push_back(std::move(group));
  }
  return section;
}

}  // namespace fde::bench
