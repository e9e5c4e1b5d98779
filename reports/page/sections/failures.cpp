#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "analysis/text.hpp"
#include "page/page_data.hpp"
#include "stepping/scheme.hpp"

namespace fde {
namespace {

std::vector<Cell> row(const PageInput& page, const std::vector<std::string>& steps, const MeasuredRun& run) {
  return {{.text = page.label(run.key), .detail = page.grid(run.key.setup)},
          {.text = fmt::format("{}", fmt::join(steps, ", "))},
          {.text = sentence(run.ending)}};
}

}  // namespace

// Neighbouring step counts that end for the same reason share a row.
Section failures_section(const PageInput& page) {
  Section section{
      .id = "failures",
      .title = "Refused and failed",
      .paragraphs = {"Every run that did not come to its end, or whose end says nothing about the solution, "
                     "with the reason."},
      .table = {.caption = "Refused and failed runs with their reasons",
                .columns = {{"scheme"}, {"N"}, {"reason"}}},
      .folded = true};
  for (const RunSpan scene : by_scene(page.runs.failed)) {
    RowGroup group{.title = name_of_scene(scene.front().key.scene).title};
    for (const RunSpan line : by_line(scene)) {
      std::vector<std::string> steps;
      for (auto run = line.begin(); run != line.end(); ++run) {
        steps.push_back(count_text(run->steps));
        if (std::next(run) != line.end() && std::next(run)->ending == run->ending) continue;
        group.rows.push_back(row(page, steps, *run));
        steps.clear();
      }
    }
    section.table.groups.push_back(std::move(group));
  }
  return section;
}

// Our schemes, and other programs behind them.
Section schemes_section(const PageInput& page) {
  Section section{.id = "schemes",
                  .title = "The schemes",
                  .table = {.caption = "The schemes and where they come from",
                            .columns = {{"scheme"}, {"title"}, {"source"}}}};
  RowGroup rows;
  for (const auto& scheme : schemes()) {
    const std::string id(scheme.id);
    const auto of_this = [&](const MeasuredRun& run) { return run.key.scheme == id; };
    if (std::ranges::any_of(page.runs.finished, of_this) || std::ranges::any_of(page.runs.failed, of_this)) {
      rows.rows.push_back(
          {{.text = id}, {.text = std::string(scheme.title)}, {.text = std::string(scheme.source)}});
    }
  }
  std::set<std::string> external;
  for (const auto* runs : {&page.runs.finished, &page.runs.failed, &page.trials}) {
    for (const MeasuredRun& run : *runs) {
      if (run.key.external) external.insert(run.key.scheme);
    }
  }
  for (const auto& name : external) rows.rows.push_back({{.text = name}, {.text = "another program"}, {}});
  if (!rows.rows.empty()) section.table.groups.push_back(std::move(rows));
  return section;
}

}  // namespace fde
