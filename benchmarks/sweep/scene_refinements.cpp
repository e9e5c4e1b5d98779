// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/scene_refinements.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "fdebench/benchmarks/search/configurations.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

// Whether solutions are not smooth at 0: every row has a fractional order and belongs to no multi-term chain
// (whose first unknown is smooth).
bool starts_singular(const Problem& problem) {
  return problem.equations.empty() && std::ranges::none_of(problem.components, [](const auto& row) {
           return is_integer_order(row.order);
         });
}

}  // namespace

std::vector<RunSettings> settings_of(const Sweep& sweep, const Scheme& scheme, const Problem* problem) {
  const bool graded =
      std::ranges::find(sweep.graded, &scheme) != sweep.graded.end() && starts_singular(*problem);
  std::vector<RunSettings> settings{sweep.settings};
  if (!sweep.optimal_grids && !graded) return settings;
  RunSettings optimal = sweep.settings;
  optimal.grading = optimal_grading(scheme, *problem);
  if (sweep.optimal_grids) return {optimal};
  if (optimal != sweep.settings) settings.push_back(optimal);
  return settings;
}

SceneRefinements::SceneRefinements(const Sweep& sweep, const SceneSettings& scene, const Problem* problem) {
  for (const auto* scheme : sweep.schemes) {
    for (const RunSettings& settings : settings_of(sweep, *scheme, problem)) {
      const bool takes_many = problem != nullptr && !refusal(*scheme, *problem, settings.grading);
      add({.solver = scheme,
           .key = key_of(*scheme, scene, settings),
           .settings = settings,
           .takes_many_steps = takes_many},
          scheme->capabilities, sweep.plan);
    }
  }
  for (const auto& program : sweep.programs)
    add({&program, key_of(program, scene, sweep.settings), sweep.settings}, Capabilities{}, sweep.plan);
}

void SceneRefinements::add(std::size_t i, RefinementRun run) {
  if (run.ending.kind == SolveStatus::refused && series[i].takes_many_steps)
    run.fails_with_more_steps = false;
  refinements_[i].add(std::move(run));
}

void SceneRefinements::add(RefinementSeries of, const Capabilities& capabilities, const SweepPlan& plan) {
  const auto is_same = [&](const RefinementSeries& other) {
    return other.solver == of.solver && other.settings == of.settings;
  };
  if (std::ranges::any_of(series, is_same)) return;
  of.listed = resolutions_for(plan, capabilities);
  series.push_back(std::move(of));
  refinements_.push_back({.is_adaptive = capabilities.is_adaptive()});
}

std::vector<std::optional<StepsOrTolerance>> SceneRefinements::next_runs(const SweepPlan& plan) {
  if (plan.goal) return next_resolutions(*plan.goal, refinements_, memo_);
  std::vector<std::optional<StepsOrTolerance>> next(series.size());
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::size_t made = refinements_[i].runs.size();
    if (made < series[i].listed.size()) next[i] = series[i].listed[made];
  }
  return next;
}

bool SceneRefinements::choose_next(const SweepPlan& plan) {
  const auto next = next_runs(plan);
  for (std::size_t i = 0; i < next.size(); ++i) {
    series[i].ended = !next[i];
    series[i].is_due = !plan.goal && next[i];
  }
  if (plan.goal)
    for (const std::size_t i : due_runs(*plan.goal, refinements_, next)) series[i].is_due = true;
  bool is_any = false;
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (!series[i].is_due) continue;
    series[i].key.settings.resolution = series[i].settings.resolution = *next[i];
    is_any = true;
  }
  return is_any;
}

}  // namespace fde::bench
