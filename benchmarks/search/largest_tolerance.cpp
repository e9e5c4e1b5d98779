// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/largest_tolerance.hpp"

#include <cmath>
#include <utility>

namespace fde::bench {
namespace {

constexpr double loosest = 0.1, tightest = 1e-15, least_part = 1e-6;

}  // namespace

std::optional<CandidateRun> largest_tolerance(double wanted,
                                              const std::function<CandidateRun(double requested)>& attempt) {
  double within = wanted, beyond = wanted;
  std::optional<CandidateRun> best;
  CandidateRun first = attempt(wanted);
  if (first.meets_accuracy) {
    best = std::move(first);
    for (beyond = 10.0 * within; beyond <= loosest; beyond *= 10.0) {
      CandidateRun made = attempt(beyond);
      if (!made.meets_accuracy) break;
      within = beyond;
      best = std::move(made);
    }
    if (beyond > loosest) return best;
  } else {
    bool continues = first.ending.kind != SolveStatus::out_of_budget;
    while (!best && continues && within / 10.0 >= std::max(tightest, least_part * wanted)) {
      beyond = std::exchange(within, within / 10.0);
      CandidateRun made = attempt(within);
      continues = made.ending.kind != SolveStatus::out_of_budget;
      if (made.meets_accuracy) best = std::move(made);
    }
    if (!best) return std::nullopt;
  }
  while (beyond > 2.0 * within) {
    const double middle = std::sqrt(within * beyond);
    CandidateRun made = attempt(middle);
    (made.meets_accuracy ? within : beyond) = middle;
    if (made.meets_accuracy) best = std::move(made);
  }
  return best;
}

}  // namespace fde::bench
