// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/sweep_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/requests/own_scheme.hpp"
#include "fdebench/benchmarks/requests/solve_request.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/sweep/trials.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {
namespace {

constexpr TimingRepeats of_default_sweep{.min_seconds = 0.002, .enough_seconds = 0.03};

const RequestField scene{"scene"}, steps{"steps"}, accuracy{"accuracy"}, external{"external"},
    examine{"examine"};

// The first tolerance; nullptr: there is none.
const Tolerance* tolerance_of(const SweepRequest& request) {
  for (const auto& resolution : request.resolutions)
    if (const auto* tolerance = std::get_if<Tolerance>(&resolution)) return tolerance;
  return nullptr;
}

bool has_steps(const SweepRequest& request) {
  return std::ranges::any_of(request.resolutions,
                             [](const auto& one) { return std::holds_alternative<int>(one); });
}

std::string grid_of(const SweepRequest& request) {
  return request.optimal_grading ? std::string(optimal_grid) : grid_text(request.settings.grading);
}

void require_fitting_programs(const SweepRequest& request) {
  std::set<std::string_view> names;
  for (const auto& [name, command] : request.programs) {
    require_external_name("external", name);
    if (!names.insert(name).second)
      refuse_value("external", fmt::format("{}={}", name, command), {"a name that no other program has"});
  }
  if (request.programs.empty()) return;
  if (const auto* tolerance = tolerance_of(request)) {
    refuse_value("accuracy", fmt::format("{}", tolerance->rtol),
                 {"without ", external, ", whose programs take ", steps});
  }
  if (request.optimal_grading)
    refuse_value("grid", grid_of(request), {"uniform or graded:R beside ", external});
}

// Timings that are left out, or repeated where they are disturbed, need runs that do not depend on times.
void require_fitting_times(const SweepRequest& request) {
  constexpr auto allowed = "with numbers of steps or tolerances: otherwise times decide which runs are made";
  const bool searches = request.resolutions.empty() && !request.thorough && !request.trials;
  if (request.examine && searches) refuse_value("examine", "yes", {allowed});
  if (request.undisturbed && searches) refuse_value("undisturbed", "yes", {allowed});
  if (request.examine && request.undisturbed)
    refuse_value("undisturbed", "yes", {"without ", examine, ", which times nothing"});
}

// Each value alone.
void require_ranges_of(const SweepRequest& request) {
  for (const auto& resolution : request.resolutions) require_allowed(resolution);
  require_allowed(request.settings);
  if (request.budget) require_in("budget", *request.budget, positive);
  require_in("repeat", request.repeats, repeat_counts);
}

void require_fitting(const SweepRequest& request) {
  require_ranges_of(request);
  std::vector<const Scheme*> own = request.schemes;
  std::erase_if(own, [](const Scheme* scheme) { return find_scheme(scheme->id) == scheme; });
  require_own_ids(own);
  require_own_measures(request.measures);
  const bool is_listed = !request.resolutions.empty();
  if (request.trials && (is_listed || !request.scenes.empty()))
    refuse_value("trials", "yes", {"without ", scene, " and ", steps, ", trials have their own"});
  if (request.thorough && is_listed)
    refuse_value("thorough", "yes", {"without ", steps, " and ", accuracy, ", it has its own"});
  require_fitting_programs(request);
  const bool is_uniform = request.settings.grading == 1.0 && !request.optimal_grading;
  if (tolerance_of(request) != nullptr && !has_steps(request) && !is_uniform) {
    refuse_value("grid", grid_of(request),
                 {"with ", steps, ": schemes that take ", accuracy, " choose their times"});
  }
  require_fitting_times(request);
}

SweepPlan plan_of(const SweepRequest& request) {
  if (!request.resolutions.empty()) return {.resolutions = request.resolutions};
  return request.thorough ? thorough_plan() : default_plan();
}

Sweep sweep_of(const SweepRequest& request) {
  constexpr int attempts = 3;
  const bool has_schemes = !request.schemes.empty() || !request.programs.empty();
  Sweep sweep{.scenes = request.scenes.empty() ? sweep_scenes() : request.scenes,
              .schemes = has_schemes ? request.schemes : sweep_schemes(),
              .programs = request.programs,
              .plan = plan_of(request),
              .settings = request.settings,
              .optimal_grids = request.optimal_grading,
              .measures = request.measures,
              .examines_only = request.examine,
              .retimes = request.undisturbed};
  if (sweep.plan.goal) sweep.repeats = of_default_sweep;
  sweep.repeats.most = request.repeats;
  if (request.undisturbed) sweep.repeats.attempts = attempts;
  sweep.settings.budget = request.budget.value_or(!request.resolutions.empty() ? budget_of_listed_runs
                                                  : sweep.plan.goal            ? budget_of_search
                                                                               : budget_of_thorough_runs);
  return sweep;
}

}  // namespace

std::vector<Sweep> sweeps_of(const SweepRequest& request) {
  require_fitting(request);
  Sweep sweep = sweep_of(request);
  std::vector<Sweep> sweeps;
  const bool is_default = request.resolutions.empty() && request.scenes.empty();
  if (is_default) sweeps = sweeps_of_trials(sweep, request.thorough);
  if (is_default && request.schemes.empty() && grid_of(request) == grid_text(1.0))
    sweep.graded = graded_schemes();
  if (!request.trials) sweeps.push_back(std::move(sweep));
  return sweeps;
}

}  // namespace fde::bench
