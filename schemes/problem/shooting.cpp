// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/shooting.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace fde {
namespace {

constexpr double unit_rounding = std::numeric_limits<double>::epsilon();

// A run with its missing values, and the residual of the conditions.
struct Shot {
  Vec values, residual;
  double size;  // of y at both ends and of the values

  [[nodiscard]] double missed() const { return residual.lpNorm<Eigen::Infinity>(); }
};

std::optional<Shot> shot(const Problem& problem, const EndOfRun& run, Vec values) {
  const Problem complete = with_initial_values(problem, values);
  const auto end = run(complete);
  if (!end) return std::nullopt;
  const Vec start = taylor_part(complete, 0.0);
  Shot made{.values = std::move(values), .residual = Vec(unknown_count(problem)), .size = 0.0};
  problem.conditions(start, *end, made.residual);
  if (!made.residual.allFinite()) return std::nullopt;
  for (const Vec& part : {start, *end, made.values})
    made.size = std::max(made.size, part.lpNorm<Eigen::Infinity>());
  return made;
}

class Shooting {
 public:
  Shooting(const Problem& problem, const EndOfRun& run, const Tolerance& noise)
      : problem_(problem), run_(run), noise_(noise) {}

  MissingValues find(MissingValues start) {
    if (start.values.size() == 0) start.values = Vec::Zero(unknown_count(problem_));
    auto now = shot(problem_, run_, start.values);
    if (!now) return start;
    derivative_ = std::move(start.derivative);
    constexpr int most_steps = 50;
    for (int step = 0; step < most_steps && !is_within(at_rounding, *now); ++step) {
      const bool is_new = derivative_.size() == 0;
      if (is_new && !differentiate(*now)) break;
      auto next = nearer(*now);
      if (!next && (is_new || is_within(met(), *now))) break;
      if (next) {
        update(*now, *next);
        now = std::move(next);
      } else {
        derivative_.resize(0, 0);
      }
    }
    return {now->values, derivative_, now->missed(), is_within(met(), *now)};
  }

 private:
  static constexpr Tolerance at_rounding{4.0 * unit_rounding, 0.0};
  [[nodiscard]] Tolerance met() const {
    return {std::max(std::sqrt(unit_rounding), noise_.rtol), noise_.atol};
  }

  // Whether F and the step that Newton's method would take are so small.
  [[nodiscard]] bool is_within(const Tolerance& tolerance, const Shot& at) const {
    const double largest = tolerance.rtol * at.size + tolerance.atol;
    if (at.missed() == 0.0) return true;
    if (derivative_.size() == 0 || at.missed() > largest) return false;
    return derivative_.fullPivLu().solve(at.residual).lpNorm<Eigen::Infinity>() <= largest;
  }

  // One-sided differences, or those to the other side where a run does not reach the end.
  bool differentiate(const Shot& now) {
    const double noise =
        std::max(noise_.rtol, unit_rounding) + (now.size > 0.0 ? noise_.atol / now.size : 0.0);
    const double relative = is_linear(problem_) ? 1.0 : std::sqrt(std::min(noise, 1.0));
    derivative_.resize(now.residual.size(), now.values.size());
    for (Eigen::Index j = 0; j < now.values.size(); ++j) {
      const double shift = relative * std::max(1.0, std::abs(now.values[j]));
      std::optional<Shot> other;
      for (const double to : {shift, -shift}) {
        Vec values = now.values;
        values[j] += to;
        if (!other) other = shot(problem_, run_, std::move(values));
      }
      if (!other) {
        derivative_.resize(0, 0);
        return false;
      }
      derivative_.col(j) = (other->residual - now.residual) / (other->values[j] - now.values[j]);
    }
    return true;
  }

  // The result of Newton's step, or of a part of it; nullopt: none is nearer.
  std::optional<Shot> nearer(const Shot& now) {
    const Eigen::FullPivLU<Matrix> factors(derivative_);
    const Vec step = factors.solve(-now.residual);
    if (!factors.isInvertible() || !step.allFinite()) return std::nullopt;
    constexpr double smallest = 0x1p-16;
    for (double part = 1.0; part >= smallest; part /= 2.0) {
      auto next = shot(problem_, run_, now.values + part * step);
      if (next && factors.solve(next->residual).norm() < (1.0 - part / 4.0) * step.norm()) return next;
      if (is_within(met(), now)) break;
    }
    return std::nullopt;
  }

  // Broyden's update, unless F has changed by noise alone.
  void update(const Shot& before, const Shot& now) {
    constexpr double some_roundings = 100.0 * unit_rounding;
    const Vec step = now.values - before.values, change = now.residual - before.residual;
    const double noise = std::max(noise_.rtol, some_roundings) * now.size + noise_.atol;
    if (change.lpNorm<Eigen::Infinity>() <= noise) return;
    derivative_ += (change - derivative_ * step) * step.transpose() / step.squaredNorm();
  }

  const Problem& problem_;
  const EndOfRun& run_;
  Tolerance noise_;
  Matrix derivative_{};
};

}  // namespace

MissingValues find_missing_values(const Problem& problem, const EndOfRun& run, const Tolerance& noise,
                                  MissingValues start) {
  return Shooting(problem, run, noise).find(std::move(start));
}

bool are_determined(const Problem& problem, const MissingValues& found, const EndOfRun& other) {
  if (found.derivative.size() == 0) return true;  // the conditions hold from the start
  constexpr double large = 0.25;
  // Values that differ by some roundings, so that two runs do not round alike.
  const auto again = shot(problem, other, (1.0 + 64.0 * unit_rounding) * found.values);
  if (!again) return false;
  const Vec change = found.derivative.fullPivLu().solve(again->residual);
  return change.lpNorm<Eigen::Infinity>() < large * again->size;
}

}  // namespace fde
