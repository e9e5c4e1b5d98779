// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/reports/analysis/comparison.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_rows = 200;  // per kind of change

std::vector<Cell> row(const PageInput& page, const CommonRun& run, std::string before, std::string now,
                      std::string change, bool worse) {
  const RunKey& key = run.now->key;
  const std::string label = page.label(key);
  return {{.text = label_of(key.scene), .link = section_of(key.scene)},
          {.text = label, .detail = resolution_text(key.setup), .line = label},
          {.text = std::move(before)},
          {.text = std::move(now)},
          {.text = std::move(change), .highlighted = worse}};
}

// Adds the first rows of a kind of change, under a title with the total number.
template <typename Change>
void add(Table& table, const std::string& title, const std::vector<Change>& changes, const auto& row_of) {
  if (changes.empty()) return;
  RowGroup group{.title = fmt::format("{}: {}", title, changes.size())};
  for (std::size_t i = 0; i < std::min(changes.size(), most_rows); ++i)
    group.rows.push_back(row_of(changes[i]));
  table.groups.push_back(std::move(group));
}

std::string verdict_text(const TrialResult& verdict, const MeasuredRun& run) {
  return fmt::format("{} ({})", verdict.word, sentence(run.ending));
}

}  // namespace

Section compared_section(const PageInput& page, const Runs& before) {
  const Comparison found = compare(before, page.runs);
  Section section{
      .id = "compared",
      .title = "Compared with the first results",
      .paragraphs = {fmt::format(
          "{} runs are in both, {} only in the first, {} only in the second, which the rest of the page "
          "is of. Where a verdict got worse or an error grew, it is marked. Errors that moved by less than a "
          "hundredth, or by less than what rounding and the reference leave open, are left out, and "
          "times whose 95 % intervals meet.",
          found.common, found.only_before, found.only_now)},
      .table = {.caption = "Runs of both results that changed",
                .columns = {{"scene"}, {"scheme"}, {"first"}, {"second"}, {"change"}}}};
  add(section.table, "Verdicts and endings", found.endings, [&](const EndingChange& change) {
    return row(page, change.run, verdict_text(change.before, *change.run.before),
               verdict_text(change.now, *change.run.now), change.is_worse() ? "worse" : "changed",
               change.is_worse());
  });
  add(section.table, "Errors", found.errors, [&](const ErrorChange& error) {
    auto factor =
        error.before > 0.0 ? fmt::format("× {:.3g}", error.now / error.before) : std::string("from 0");
    return row(page, error.run, error_text(error.before), error_text(error.now),
               fmt::format("{} {}", error.quantity, factor), error.grew());
  });
  std::vector<TimeRatio> moved;
  std::ranges::copy_if(found.times, std::back_inserter(moved),
                       [](const TimeRatio& time) { return time.slower() || time.faster(); });
  add(section.table, "Times", moved, [&](const TimeRatio& time) {
    return row(page, time.run, time_text(time.before.median), time_text(time.now.median),
               fmt::format("× {:.3g} ({:.3g} to {:.3g})", time.ratio, time.low, time.high), false);
  });
  return section;
}

}  // namespace fde::bench
