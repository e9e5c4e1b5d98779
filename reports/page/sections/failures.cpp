// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// Runs with the same ending: lines with the same numbers of steps.
struct EqualEndings {
  std::vector<std::string> lines, steps;
  RunOutcome first, last;

  // "not finite at step 13, t = 1.5 ... at step 102, t = 1.6".
  [[nodiscard]] std::string reason() const {
    return first == last ? sentence(first) : fmt::format("{} ... {}", sentence(first), last.detail);
  }
};

// Refusals must have the same reason. Other endings may differ in step and time, which depend on the number
// of steps.
bool alike(const RunOutcome& one, const RunOutcome& other) {
  return one.kind == other.kind && (one.kind != SolveStatus::refused || one.detail == other.detail);
}

std::string steps_or_accuracy(const MeasuredRun& run) {
  const auto* requested = std::get_if<Tolerance>(&run.key.setup.resolution);
  return requested != nullptr ? error_text(requested->rtol) : count_text(run.steps);
}

// Consecutive numbers of steps of a line with the same ending.
std::vector<EqualEndings> endings_of(const PageInput& page, RunSpan line) {
  std::vector<EqualEndings> found;
  for (const MeasuredRun& run : line) {
    if (found.empty() || !alike(found.back().last, run.ending))
      found.push_back({.lines = {page.label(run.key)}, .steps = {}, .first = run.ending, .last = {}});
    found.back().last = run.ending;
    found.back().steps.push_back(steps_or_accuracy(run));
  }
  return found;
}

}  // namespace

// Lines with the same endings for the same numbers of steps share a row.
Section failures_section(const PageInput& page) {
  Section section{
      .id = "failures",
      .title = "Refused and failed",
      .paragraphs = {"Every run that did not come to its end, or whose end says nothing about the solution, "
                     "with the reason."},
      .table = {.caption = "Refused and failed runs with their reasons",
                .columns = {{"scheme"}, {"N or accuracy"}, {"reason"}}},
      .collapsed = true};
  for (const RunSpan scene : by_scene(page.runs.failed)) {
    std::vector<EqualEndings> all;
    for (const RunSpan line : by_line(scene)) {
      for (EqualEndings& ending : endings_of(page, line)) {
        const auto same = std::ranges::find_if(all, [&](const EqualEndings& other) {
          return other.reason() == ending.reason() && other.steps == ending.steps;
        });
        if (same == all.end()) {
          all.push_back(std::move(ending));
        } else {
          same->lines.push_back(std::move(ending.lines.front()));
        }
      }
    }
    RowGroup group{.title = name_of_scene(scene.front().key.scene).title};
    for (const EqualEndings& of : all) {
      group.rows.push_back({{.text = fmt::format("{}", fmt::join(of.lines, ", "))},
                            {.text = fmt::format("{}", fmt::join(of.steps, ", "))},
                            {.text = of.reason()}});
    }
    section.table.groups.push_back(std::move(group));
  }
  return section;
}

// The schemes of this build, then external programs.
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

}  // namespace fde::bench
