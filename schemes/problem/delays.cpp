// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/delays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace fde {
namespace {

// Whether y jumps at 0: with unknown initial values it does in general.
bool jumps_at_start(const Problem& problem) {
  if (unknown_count(problem) > 0) return true;
  Vec before(problem.size());
  problem.delays.before(0.0, before);
  return before != taylor_part(problem, 0.0);
}

constexpr double rounding = 1e-13;  // of sums of lags

// Whether a sorted list has this time.
bool has(const std::vector<double>& times, double t) {
  const auto found = std::ranges::lower_bound(times, t * (1.0 - rounding));
  return found != times.end() && *found <= t * (1.0 + rounding);
}

void insert(double t, std::vector<double>& times) { times.insert(std::ranges::upper_bound(times, t), t); }

// Adds the breaking points of f a sum of lags after 0 and after each of its own: jumps if `they_jump`,
// otherwise kinks. D^g y smooths by the order g: after k lags a kink is a power k g of the time since then,
// and powers above `smooth` do not count. An algebraic row passes on jumps and kinks as they are.
void add_sums_of_lags(bool they_jump, Problem& problem) {
  constexpr double smooth = 4.0;
  constexpr std::size_t most = 200;  // of those added
  const double smoothing = has_algebraic_rows(problem) ? 0.0 : smallest_order(problem);
  auto& added = they_jump ? problem.jump_times : problem.kink_times;
  std::vector<double> known = breaking_points(problem), newest = known;
  newest.insert(newest.begin(), 0.0);
  const std::size_t allowed = known.size() + most;
  for (double power = 0.0; power < smooth && !newest.empty(); power += smoothing) {
    std::vector<double> later;
    for (const double t : newest) {
      for (const double lag : problem.delays.lags) {
        const double next = t + lag;
        if (next >= problem.end * (1.0 - rounding) || has(known, next) || known.size() == allowed) continue;
        insert(next, known);
        insert(next, added);
        later.push_back(next);
      }
    }
    std::ranges::sort(later);
    newest = std::move(later);
  }
}

}  // namespace

void add_jumps_of_start(Problem& problem) {
  if (problem.delays.lags.empty() || !jumps_at_start(problem)) return;
  for (const double lag : problem.delays.lags) {
    const double t = std::abs(lag - problem.end) <= rounding * problem.end ? problem.end : lag;
    if (t <= problem.end && !has(problem.jump_times, t)) insert(t, problem.jump_times);
  }
}

Delays linear_delays(std::vector<double> lags, const Matrix& a, const std::vector<Matrix>& factors,
                     const Vec& before) {
  return {.lags = lags,
          .before = [before](double, Out y) { y = before; },
          .rhs =
              [lags = std::move(lags), a, factors](double t, In y, const Past& past, Out f) {
                Vec earlier(y.size());
                f = a * y;
                for (std::size_t k = 0; k < lags.size(); ++k) {
                  past(t - lags[k], earlier);
                  f += factors[k] * earlier;
                }
              }};
}

std::vector<Matrix> delayed_jacobians_at(const Problem& problem, double t, In y, const Past& past) {
  const auto& lags = problem.delays.lags;
  std::vector<Matrix> jacobians(lags.size(), Matrix(y.size(), y.size()));
  Vec above(y.size()), below(y.size());
  for (std::size_t k = 0; k < lags.size(); ++k) {
    Vec earlier(y.size());
    past(t - lags[k], earlier);
    // A right-hand side says by the time alone which of its lags it looks back.
    const auto nearest = [&](double time) {
      return std::ranges::min_element(lags, {}, [&](double lag) { return std::abs(t - lag - time); });
    };
    const Past moved = [&](double time, Out value) {
      past(time, value);
      if (nearest(time) - lags.begin() == static_cast<std::ptrdiff_t>(k)) value = earlier;
    };
    for (Eigen::Index j = 0; j < y.size(); ++j) {
      const double value = earlier[j], shift = 0x1p-18 * std::max(1.0, std::abs(value));
      earlier[j] = value + shift;
      problem.delays.rhs(t, y, moved, above);
      earlier[j] = value - shift;
      problem.delays.rhs(t, y, moved, below);
      earlier[j] = value;
      jacobians[k].col(j) = (above - below) / (2.0 * shift);
    }
  }
  return jacobians;
}

BoundProblem::BoundProblem(const Problem& problem) : delays_(problem.delays), bound_(problem) {
  if (problem.delays.lags.empty()) return;
  set_solution([start = taylor_part(problem, 0.0)](double, Out y) { y = start; });
  add_jumps_of_start(bound_);
  add_sums_of_lags(has_algebraic_rows(problem) && jumps_at_start(problem), bound_);
  bind();
}

void BoundProblem::at(double t, Out y) const {
  if (t < 0.0) {
    delays_.before(t, y);
  } else {
    solution_(t, y);
  }
}

// The functions of the problem that do not know earlier values are left out.
void BoundProblem::bind() {
  const Past past = [this](double t, Out y) { at(t, y); };
  bound_.delays = {};
  bound_.rhs = [this, past](double t, In y, Out f) { delays_.rhs(t, y, past, f); };
  if (delays_.jacobian) {
    bound_.derivatives =
        DenseJacobian{[this, past](double t, In y, OutMatrix j) { delays_.jacobian(t, y, past, j); }};
  }
  bound_.text = {};
  bound_.increments = {};
  bound_.equations.clear();
  bound_.range = {};
  bound_.step_limits.push_back({0.0, bound_.end, delays_.lags.front()});
}

}  // namespace fde
