// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/reports/page/facts.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// Runs with the same ending: lines with the same numbers of steps, or the same tolerances.
struct EqualEndings {
  std::vector<std::string> lines;
  std::vector<int> steps;
  std::vector<double> tolerances;
  RunOutcome first, last;

  [[nodiscard]] bool has_runs_and_reason_of(const EqualEndings& other) const {
    return steps == other.steps && tolerances == other.tolerances && first == other.first &&
           last == other.last;
  }
};

// Refusals must have the same reason. Other endings may differ in step and time, which depend on the number
// of steps.
bool alike(const RunOutcome& one, const RunOutcome& other) {
  return one.kind == other.kind && (one.kind != SolveStatus::refused || one.detail == other.detail);
}

// Consecutive numbers of steps of a line with the same ending.
std::vector<EqualEndings> endings_of(const PageInput& page, RunSpan line) {
  std::vector<EqualEndings> found;
  for (const Record& run : line) {
    if (found.empty() || !alike(found.back().last, run.ending))
      found.push_back({{page.label(run.key)}, {}, {}, run.ending, {}});
    auto& of = found.back();
    of.last = run.ending;
    if (const auto* requested = std::get_if<Tolerance>(&run.key.settings.resolution)) {
      of.tolerances.push_back(requested->rtol);
    } else {
      of.steps.push_back(run.steps);
    }
  }
  return found;
}

// Lines with the same endings of the same runs share a row.
std::vector<EqualEndings> endings_of_scene(const PageInput& page, RunSpan scene) {
  std::vector<EqualEndings> all;
  for (const RunSpan line : by_line(scene)) {
    for (EqualEndings& ending : endings_of(page, line)) {
      const auto same = std::ranges::find_if(
          all, [&](const EqualEndings& other) { return other.has_runs_and_reason_of(ending); });
      if (same == all.end()) {
        all.push_back(std::move(ending));
      } else {
        same->lines.push_back(std::move(ending.lines.front()));
      }
    }
  }
  return all;
}

json row(const EqualEndings& of) {
  json facts = ending_facts(of.first);
  facts.update({{"lines", of.lines}, {"steps", of.steps}, {"requested", of.tolerances}});
  if (of.last != of.first) facts["last"] = of.last.detail;
  return facts;
}

}  // namespace

json failures_section(const PageInput& page) {
  json groups = json::array();
  for (const RunSpan scene : by_scene(page.runs.failed)) {
    json rows = json::array();
    for (const EqualEndings& of : endings_of_scene(page, scene)) rows.push_back(row(of));
    groups.push_back({{"title", name_of_scene(page, scene.front().key.scene).title}, {"rows", rows}});
  }
  return {{"id", "failures"}, {"groups", groups}};
}

// The schemes of this build, then those of another version and external programs, of which the name is known.
json schemes_section(const PageInput& page) {
  json rows = json::array();
  for (const auto& scheme : schemes()) {
    const auto of_this = [&](const Record& run) { return run.key.scheme == scheme.id; };
    const auto has = [&](const Runs& runs) {
      return std::ranges::any_of(runs.finished, of_this) || std::ranges::any_of(runs.failed, of_this);
    };
    if (has(page.runs) || has(page.families))
      rows.push_back({{"scheme", scheme.id}, {"title", scheme.title}, {"source", scheme.source}});
  }
  std::set<std::string> others;
  for (const auto* runs : {&page.runs.finished, &page.runs.failed, &page.trials, &page.families.finished,
                           &page.families.failed}) {
    for (const Record& run : *runs) {
      if (find_scheme(run.key.scheme) == nullptr) others.insert(run.key.scheme);
    }
  }
  for (const auto& name : others) rows.push_back({{"scheme", name}});
  return {{"id", "schemes"}, {"groups", json::array({{{"rows", rows}}})}};
}

}  // namespace fde::bench
