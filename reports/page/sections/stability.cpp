#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "analysis/text.hpp"
#include "analysis/verdict.hpp"
#include "page/page_data.hpp"
#include "stepping/scheme.hpp"
#include "sweep/trials.hpp"

namespace fde {
namespace {

// The schemes of the trials' runs, in the order of their list.
std::vector<std::string> schemes_of(const std::vector<MeasuredRun>& runs) {
  std::vector<std::string> ids;
  for (const auto& scheme : schemes()) {
    if (std::ranges::find(runs, scheme.id, &MeasuredRun::scheme) != runs.end()) ids.emplace_back(scheme.id);
  }
  return ids;
}

Cell cell(const std::vector<MeasuredRun>& runs, const std::string& scene, const std::string& scheme) {
  const auto found = std::ranges::find_if(
      runs, [&](const MeasuredRun& run) { return run.scene == scene && run.scheme == scheme; });
  if (found == runs.end()) return {.text = "not run"};
  const Verdict of = verdict(*found);
  return {.text = name(of),
          .detail = because(*found),
          .marked = of == Verdict::fails || of == Verdict::inaccurate};
}

// "5 of 12", and how many it refuses or stops at rightly.
Cell survivals(const std::vector<MeasuredRun>& runs, const std::string& scheme) {
  std::map<Verdict, int> counts;
  int total = 0;
  for (const auto& run : runs) {
    if (run.scheme != scheme) continue;
    ++counts[verdict(run)];
    ++total;
  }
  std::vector<std::string> others;
  for (const Verdict of : {Verdict::stops, Verdict::refuses}) {
    if (counts[of] > 0) others.push_back(fmt::format("{} {}", name(of), counts[of]));
  }
  return {.text = fmt::format("{} of {}", counts[Verdict::survives], total),
          .detail = fmt::format("{}", fmt::join(others, ", "))};
}

std::vector<Cell> row(const std::vector<MeasuredRun>& runs, const Trial& trial,
                      const std::vector<std::string>& schemes) {
  const std::string label = trial.scene.label();
  std::vector<Cell> cells{{.text = label, .detail = "N = " + count_text(trial.steps)}};
  for (const auto& scheme : schemes) cells.push_back(cell(runs, label, scheme));
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
           "judged where there is no reference or the solution itself is beyond double. Below the "
           "verdict: the error at the end as a part of the value, from when on rounding is at least "
           "a quarter of it, and the time of the solve. Why each scheme fares as it does: "
           "docs/stability.md."},
      .table = {.caption = "Verdicts by scene and scheme", .columns = {{"scene"}}}};
  const auto ids = schemes_of(page.trials);
  std::vector<Cell> counts{{.text = "survived"}};
  for (const auto& id : ids) {
    section.table.columns.push_back({id});
    counts.push_back(survivals(page.trials, id));
  }
  if (!ids.empty()) section.table.groups.push_back({.rows = {counts}});
  for (const Trial& trial : trials()) {
    const auto made = std::ranges::find(page.trials, trial.scene.label(), &MeasuredRun::scene);
    if (made == page.trials.end()) continue;
    auto& groups = section.table.groups;
    if (groups.back().title != trial.kind) groups.push_back({.title = trial.kind});
    groups.back().rows.push_back(row(page.trials, trial, ids));
  }
  return section;
}

}  // namespace fde
