// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/fewest_steps.hpp"

#include <algorithm>
#include <cmath>

namespace fde::bench {
namespace {

using Try = std::function<CandidateRun(int steps)>;

// The next multiple of `unit` above the steps rounded up to about three digits.
int rounded_up(double steps, int unit) {
  constexpr double digits_kept = 100.0;
  const double place = std::max(1.0, std::pow(10.0, std::floor(std::log10(steps / digits_kept))));
  const double whole = std::ceil(steps / place) * place;
  return static_cast<int>(std::ceil(whole / unit) * unit);
}

// Secant in log N and log e: the N at which the line through both errors equals the accuracy.
double steps_between(const CandidateRun& low, const CandidateRun& high, double accuracy) {
  const double middle = std::sqrt(static_cast<double>(low.steps) * high.steps);
  if (!std::isfinite(low.error) || !(low.error > high.error) || !(high.error > 0.0)) return middle;
  const double rate =
      std::log(low.error / high.error) / std::log(static_cast<double>(high.steps) / low.steps);
  return low.steps * std::pow(low.error / accuracy, 1.0 / rate);
}

// Narrows the bracket to 1.5 %: secant steps, every third one a bisection.
CandidateRun between(CandidateRun low, CandidateRun high, double accuracy, int unit, const Try& attempt) {
  constexpr int most_tries = 8;
  constexpr double close = 1.015, more = 1.003;
  for (int i = 0; i < most_tries && high.steps > close * low.steps; ++i) {
    int steps = rounded_up(more * steps_between(low, high, accuracy), unit);
    if (steps <= low.steps || steps >= high.steps || i % 3 == 2)
      steps = rounded_up(std::sqrt(static_cast<double>(low.steps) * high.steps), unit);
    if (steps <= low.steps || steps >= high.steps) break;
    CandidateRun made = attempt(steps);
    (made.meets_accuracy ? high : low) = std::move(made);
  }
  return high;
}

CandidateRun scanned_below(CandidateRun best, int unit, const Try& attempt) {
  constexpr double ratio = 1.05, part = 16.0;
  const double last = best.steps / part;
  CandidateRun before = best;
  for (int steps = best.steps; steps > unit && steps > last;) {
    steps = std::min(steps - 1, static_cast<int>(steps / ratio)) / unit * unit;
    if (steps < 1) break;
    CandidateRun made = attempt(steps);
    if (made.meets_accuracy) {
      best = made;
    } else if (!before.meets_accuracy && made.signed_error * before.signed_error < 0.0) {
      if (auto found = at_sign_change(made, before, unit, attempt)) best = std::move(*found);
    }
    before = std::move(made);
  }
  return best;
}

}  // namespace

std::optional<CandidateRun> at_sign_change(CandidateRun few, CandidateRun many, int unit,
                                           const Try& attempt) {
  while (many.steps - few.steps > unit) {
    CandidateRun made = attempt((few.steps + many.steps) / 2 / unit * unit);
    if (made.steps <= few.steps || !std::isfinite(made.error)) return std::nullopt;
    if (made.meets_accuracy) return made;
    (made.signed_error * many.signed_error > 0.0 ? many : few) = std::move(made);
  }
  return std::nullopt;
}

CandidateRun fewest_steps(const std::vector<CandidateRun>& refinements, double accuracy, int unit, bool scan,
                          const Try& attempt) {
  CandidateRun best = refinements.back();
  if (refinements.size() > 1)
    best = between(refinements[refinements.size() - 2], best, accuracy, unit, attempt);
  return scan ? scanned_below(std::move(best), unit, attempt) : best;
}

int more_steps(int steps, int unit) { return rounded_up(1.01 * steps + 1.0, unit); }

}  // namespace fde::bench
