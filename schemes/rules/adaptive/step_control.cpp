// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/schemes/stepping/error_tolerance.hpp"

namespace fde {

namespace {

constexpr double integral = 0.7, proportional = 0.4;  // exponents times the rate
constexpr double aim = 0.8;                           // of the length that would make the error 1
constexpr double least = 0.1, most = 4.0;             // of the previous length
constexpr double unsolved = 0.25;
constexpr double worthwhile = 1.2;  // a smaller increase keeps the length, so that factors can be reused
constexpr double smallest_error = 1e-6;

// As parts of the end. A component that starts from 0 has no correct digits after a first step, however
// short. None are required while (length / end)^order, which estimates its size relative to its later size,
// is below short_enough.
constexpr double short_enough = 1e-14;
constexpr double shortest_first = 1e-290;

bool asks_digits(const Component& component, double part_of_end) {
  return part_of_end > shortest_first && std::pow(part_of_end, component.order) > short_enough;
}

}  // namespace

bool PiController::update(double error, double length) {
  if (!(error <= 1.0)) {
    const double factor =
        std::isfinite(error) ? std::max(aim * std::pow(error, -1.0 / rate_), least) : unsolved;
    length_ = factor * length;
    rejected_ = true;
    return false;
  }
  const double now = std::max(error, smallest_error);
  const double factor = aim * std::pow(now, -integral / rate_) * std::pow(last_error_, proportional / rate_);
  const double longest = rejected_ ? 1.0 : most;
  const double bounded = std::clamp(factor, least, longest);
  length_ = bounded >= 1.0 && bounded < worthwhile ? length : bounded * length;
  last_error_ = now;
  rejected_ = false;
  return true;
}

bool exempt_from_relative_tolerance(const Problem& problem, In start, double part_of_end) {
  bool any = false;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const auto& component = problem.component(i);
    if (start[i] != 0.0 || is_algebraic(component)) continue;
    if (asks_digits(component, part_of_end)) return false;
    any = true;
  }
  return any;
}

double initial_step_size(const Problem& problem, const Tolerance& accuracy, Run& run) {
  constexpr double shrink = 0.1;
  const ErrorTolerance allowed(accuracy);
  const TaylorPart taylor(problem);
  const Vec& start = run.start();
  // Infinite entries at the start count as 0: the values of f after the start suffice.
  const Vec f = run.rhs(0.0, start).unaryExpr([](double v) { return std::isfinite(v) ? v : 0.0; });
  Vec y(f.size()), unit(f.size());
  for (double length = std::min(problem.end, longest_step(problem, 0.0));; length *= shrink) {
    if (length <= shortest_first * problem.end) return length;
    taylor.at(length, y);
    for (Eigen::Index i = 0; i < unit.size(); ++i) {
      const double order = problem.component(i).order;
      unit[i] = order > 0.0 ? std::pow(length, order) / std::tgamma(order + 1.0) : 0.0;
    }
    y += unit.cwiseProduct(f);
    if (!y.allFinite()) continue;
    const Vec change = unit.cwiseProduct(run.rhs(length, y) - f).cwiseAbs();
    const Vec limit = allowed.on_step(y.cwiseAbs().cwiseMax(start.cwiseAbs()), y.cwiseAbs());
    const auto passes = [&](Eigen::Index i) {
      const auto& component = problem.component(i);
      return change[i] <= limit[i] ||
             (start[i] == 0.0 && std::isfinite(change[i]) && !asks_digits(component, length / problem.end));
    };
    bool passed = true;
    for (Eigen::Index i = 0; i < unit.size(); ++i) passed = passed && passes(i);
    if (passed) return length;
  }
}

BlowUpDetector::BlowUpDetector(In start)
    : largest_(start.cwiseAbs()),
      doubled_at_(Vec::Zero(start.size())),
      doubling_time_(Vec::Constant(start.size(), std::numeric_limits<double>::infinity())),
      faster_doublings_(doubled_at_) {}

void BlowUpDetector::accept_step(double t, In y) {
  constexpr double sooner = 0.75;  // of the previous duration: doublings are detected at the ends of steps
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double size = std::abs(y[i]), took = t - doubled_at_[i];
    if (size < 2.0 * largest_[i]) continue;
    faster_doublings_[i] = took <= sooner * doubling_time_[i] ? faster_doublings_[i] + 1.0 : 0.0;
    doubling_time_[i] = took;
    doubled_at_[i] = t;
    largest_[i] = size;
  }
}

bool BlowUpDetector::is_near(double t) const {
  constexpr double several = 4.0, small_part = 1e-6;
  for (Eigen::Index i = 0; i < faster_doublings_.size(); ++i) {
    if (faster_doublings_[i] >= several && doubling_time_[i] <= small_part * t &&
        t - doubled_at_[i] <= doubling_time_[i])
      return true;
  }
  return false;
}

}  // namespace fde
