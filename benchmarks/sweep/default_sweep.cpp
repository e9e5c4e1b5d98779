// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/default_sweep.hpp"

#include <fmt/format.h>

#include <string_view>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"

namespace fde::bench {

std::vector<SceneVariant> default_scenes() {
  std::vector<SceneVariant> variants;
  for (const auto& factory : built_in_scenes()) variants.push_back({.factory = &factory});
  for (const auto* text :
       {"relaxation:gamma=0.2", "relaxation:gamma=1.5", "power:p=0.7", "pendulum:alpha=1.25,beta=0.75",
        "pendulum:alpha=1.9,beta=0.1", "fractional_diffusion:components=8"}) {
    variants.push_back(parse_variant(text));
  }
  return variants;
}

std::vector<SceneVariant> sweep_scenes() {
  auto variants = default_scenes();
  const auto add = [&](std::string_view scene, const std::vector<std::string_view>& settings) {
    for (const auto setting : settings)
      variants.push_back(parse_variant(fmt::format("{}:{}", scene, setting)));
  };
  const std::vector<std::string_view> others{"formulation=acceleration", "formulation=stabilised",
                                             "formulation=multiplier"};
  add("fractional_constraint_2d",
      {"formulation=multiplier", "alpha=0.3", "alpha=0.3,formulation=acceleration",
       "alpha=0.3,formulation=stabilised", "alpha=0.3,formulation=multiplier"});
  for (const auto* scene : {"nonholonomic_particle", "knife_edge", "loxodrome", "fractional_knife_edge"})
    add(scene, others);
  for (const auto* scene : {"isokinetic", "fractional_constraint_nonlinear"})
    add(scene, {"formulation=stabilised", "formulation=multiplier"});
  add("nonlinear_fractional_oscillator", {"form=integrated", "form=multiplier"});
  add("fractional_diffusion_2d", {"medium=halves,start=step"});
  return variants;
}

SweepPlan thorough_plan() {
  SweepPlan plan;
  for (int steps = 64; steps <= 524288; steps *= 2) plan.resolutions.emplace_back(steps);
  for (const double error : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13})
    plan.resolutions.emplace_back(Tolerance{error, error});
  return plan;
}

SweepPlan default_plan() {
  SearchGoal goal{.coarsest_steps = 64,
                  .fewest_runs = 4,
                  .most_steps = 1 << 19,
                  .loosest = 1e-2,
                  .tightest = 1e-13,
                  .most_seconds = 0.2,
                  .margin = 1.2,
                  .long_run = 1e-3,
                  .long_run_over_grid = 1e-4,
                  .short_run = 1e-3,
                  .binary_digits = 5,
                  .closeness = 1.05};
  for (const double error : default_accuracies) {
    goal.targets.push_back({error_at_end, error, true});
    goal.targets.push_back({error_maximum, error});
  }
  return {.goal = goal};
}

std::vector<const Scheme*> sweep_schemes() {
  std::vector<const Scheme*> all;
  for (const auto& scheme : schemes()) all.push_back(&scheme);
  return all;
}

std::vector<const Scheme*> graded_schemes() {
  return {find_scheme("l1"), find_scheme("l1_2"), find_scheme("l2_1_sigma"),
          find_scheme("product_trapezoidal")};
}

}  // namespace fde::bench
