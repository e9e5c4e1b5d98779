// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fdebench/benchmarks/sweep/trials.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/analysis/trial_result.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// The labels of the trials' lines, without repetitions, in the order of the list of schemes.
std::vector<std::string> lines_of(const PageInput& page) {
  std::vector<std::string> lines;
  for (const auto& scheme : schemes()) {
    for (const auto& run : page.trials) {
      if (run.key.scheme != scheme.id) continue;
      auto line = page.label(run.key);
      if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
    }
  }
  return lines;
}

Cell cell(const PageInput& page, const SceneSettings& scene, const std::string& line) {
  const auto found = std::ranges::find_if(page.trials, [&](const MeasuredRun& run) {
    return run.key.scene == scene && page.label(run.key) == line;
  });
  if (found == page.trials.end()) return {.text = "not run"};
  const std::string word(trial_result(*found).word);
  const auto error = (*found)["error_relative"];
  // Digits of agreement: 16 for an error at rounding, 0 for an error as large as the value.
  const double correct = error && word == survives.word ? -std::log10(std::max(*error, 1e-16)) : 0.0;
  return {.text = word,
          .detail = error ? error_text(*error) : "",
          .tooltip = reason_for(*found),
          .verdict = word,
          .strength = std::clamp(correct / 16.0, 0.0, 1.0)};
}

// "5 of 12", with the numbers of refusals and of runs that stop rightly.
Cell survivals(const PageInput& page, const std::string& line) {
  std::map<TrialResult, int> counts;
  int total = 0;
  for (const auto& run : page.trials) {
    if (page.label(run.key) != line) continue;
    ++counts[trial_result(run)];
    ++total;
  }
  std::vector<std::string> others;
  for (const TrialResult& of : {stops, refuses}) {
    if (counts[of] > 0) others.push_back(fmt::format("{} {}", of.word, counts[of]));
  }
  return {.text = fmt::format("{} of {}", counts[survives], total),
          .tooltip = fmt::format("{}", fmt::join(others, ", "))};
}

std::vector<Cell> row(const PageInput& page, const Trial& trial, const std::vector<std::string>& lines) {
  std::vector<Cell> cells{{.text = trial.scene.label(), .detail = "N = " + count_text(trial.steps)}};
  for (const auto& line : lines) cells.push_back(cell(page, trial.scene.key(), line));
  return cells;
}

}  // namespace

Section stability_section(const PageInput& page) {
  Section section{
      .id = "stability",
      .title = "Stability: stiff and extreme",
      .paragraphs =
          {"What becomes of each scheme where schemes break, each scene with one number of steps. A run "
           "survives when every value at the end is within a hundredth of its size of the "
           "reference, the bound of the reference included; otherwise it is inaccurate. It fails "
           "where it ends early, or where from some step on its error is not below the size of the "
           "value up to the end. It stops rightly where the solution has a singularity, and is not "
           "judged where there is no reference or the solution itself overflows. Below the "
           "verdict is the error at the end as a part of the value; a darker colour means a smaller error. A "
           "pointer that rests there shows the reason, or from when on rounding is at least a quarter of the "
           "error, and the time of the solve. Why each scheme fares as it does: docs/stability.md."},
      .table = {.caption = "Verdicts by scene and scheme", .columns = {{"scene"}}, .is_map = true}};
  const auto lines = lines_of(page);
  std::vector<Cell> counts{{.text = "survived"}};
  for (const auto& line : lines) {
    section.table.columns.push_back({line});
    counts.push_back(survivals(page, line));
  }
  if (!lines.empty()) section.table.groups.push_back({.rows = {counts}});
  for (const Trial& trial : trials()) {
    const auto of_this = [&](const MeasuredRun& run) { return run.key.scene == trial.scene.key(); };
    if (std::ranges::none_of(page.trials, of_this)) continue;
    auto& groups = section.table.groups;
    if (groups.back().title != trial.kind) groups.push_back({.title = trial.kind});
    groups.back().rows.push_back(row(page, trial, lines));
  }
  return section;
}

}  // namespace fde::bench
