// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/configurations.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

// The smallest number of equal steps whose times contain all jumps of the right-hand side; 1 if there is none
// up to 1000.
int meeting_jumps(const Problem& problem) {
  constexpr int most = 1000;
  for (int steps = 1; steps <= most; ++steps) {
    if (has_times(Grid{problem.end, steps}, problem.jump_times)) return steps;
  }
  return 1;
}

}  // namespace

std::optional<std::string> refusal(const Scheme& scheme, const Problem& problem, double grading) {
  constexpr int few_steps = 4, many_steps = 1 << 17;
  constexpr Tolerance usual{1e-6, 1e-6};
  if (scheme.capabilities.is_adaptive()) return unsupported_reason(scheme, problem, usual);
  const auto refusal_of = [&](int steps) {
    return unsupported_reason(scheme, problem, Grid{.end = problem.end, .steps = steps, .grading = grading});
  };
  auto reason = refusal_of(few_steps);
  return reason && refusal_of(many_steps) ? std::move(reason) : std::nullopt;
}

std::vector<double> gradings_of(const Scheme& scheme, const Scene& scene, Norm norm) {
  std::vector<double> gradings{1.0};
  if (scheme.capabilities.uniform_grid || scheme.capabilities.is_adaptive()) return gradings;
  gradings.insert(gradings.end(), {1.5, 2.0, 3.0});
  constexpr double most = 10.0, step = 0.25;
  double best = 1.0, best_rate = 0.0;
  for (double grading = 1.0; grading <= most; grading += step) {
    const auto rate = theoretical_rate(scheme, scene.problem, scene.smoothness, grading, norm);
    if (!rate) return gradings;
    if (*rate > best_rate + 1e-9) std::tie(best, best_rate) = std::tuple(grading, *rate);
  }
  if (std::ranges::find(gradings, best) == gradings.end()) gradings.push_back(best);
  return gradings;
}

std::vector<ConfigurationChoice> configurations_of(const Scene& scene, Norm norm,
                                                   std::span<const Scheme* const> own) {
  std::vector<ConfigurationChoice> choices;
  const int unit = meeting_jumps(scene.problem);
  const auto add = [&](const Scheme& scheme) {
    if (auto refused = refusal(scheme, scene.problem, 1.0)) {
      choices.push_back({.configuration = {&scheme}, .refused = std::move(refused)});
      return;
    }
    for (const double grading : gradings_of(scheme, scene, norm)) {
      if (refusal(scheme, scene.problem, grading)) continue;
      choices.push_back({.configuration = {&scheme, grading}});
      if (unit > 1 && grading == 1.0 && !scheme.capabilities.is_adaptive())
        choices.push_back({.configuration = {&scheme, grading}, .unit = unit});
    }
  };
  for (const Scheme& scheme : schemes()) add(scheme);
  for (const Scheme* scheme : own) add(*scheme);
  return choices;
}

}  // namespace fde::bench
