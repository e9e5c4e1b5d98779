// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/optimal_grading.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/problem/chain.hpp"

namespace fde {
namespace {

constexpr double largest = 10.0;

Smoothness smoothness_of_rows(const Problem& problem) {
  std::vector<double> steps{1.0};
  for (const auto& component : problem.components) {
    if (!is_algebraic(component)) steps.push_back(component.order);
  }
  Smoothness smoothness;
  for (const auto& component : problem.components) {
    auto& powers = smoothness.powers.emplace_back();
    if (is_algebraic(component)) continue;
    std::vector<double> start{component.order};
    if (component.order > 1.0) start.push_back(1.0);
    powers = power_lattice(start, steps, component.order + 2.0);
  }
  return smoothness;
}

// The chains of all equations, with 1 for every initial value, so that no power is missing.
std::vector<Chain> started(const Problem& problem) {
  std::vector<Chain> chains;
  for (const auto& equation : problem.equations) {
    const Chain chain = chain_of(problem, equation);
    std::vector<double> initial = chain.initial();
    std::ranges::fill(initial, 1.0);
    chains.emplace_back(chain.leading(), chain.terms(), initial, chain.first_row());
  }
  return chains;
}

// Whether every row belongs to a multi-term equation and all have one leading order, as smoothness_of_chains
// needs.
bool only_chains(const Problem& problem, const std::vector<Chain>& chains) {
  Eigen::Index rows = 0;
  for (const auto& chain : chains) {
    if (!same_order(chain.leading().order, chains.front().leading().order)) return false;
    rows += chain.size();
  }
  return rows == problem.size();
}

}  // namespace

Smoothness generic_smoothness(const Problem& problem) {
  const auto chains = started(problem);
  if (!chains.empty() && only_chains(problem, chains)) return smoothness_of_chains(chains);
  return smoothness_of_rows(problem);
}

double optimal_grading(const Scheme& scheme, const Problem& problem) {
  if (!scheme.expected_rate || is_two_sided(problem)) return 1.0;
  if (unsupported_reason(scheme, problem, Grid{.end = problem.end, .steps = 2, .grading = 2.0})) return 1.0;
  const Smoothness smoothness = generic_smoothness(problem);
  const auto rate = [&](double grading) {
    return scheme.expected_rate(problem, smoothness, grading, Norm::maximum);
  };
  constexpr double rounding = 1e-9;
  const double best = rate(largest);
  double low = 1.0, high = largest;
  if (rate(low) >= best - rounding) return low;
  while (high - low > rounding) {  // bisection: the rate does not decrease with the grading
    const double middle = 0.5 * (low + high);
    (rate(middle) >= best - rounding ? high : low) = middle;
  }
  return std::ceil(100.0 * (high - 1e-6)) / 100.0;
}

}  // namespace fde
