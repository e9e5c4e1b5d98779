// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/reset_locator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fdebench/reference/nonlinear/march/sign_changes.hpp"

namespace fde::reference {
namespace {

constexpr double next_to_end = 1e-12;  // relative: no piece can be shorter
constexpr double of_noise =
    2e-3;  // what is noise at the start and at an event, where nothing is interpolated

[[noreturn]] void reject_next(double t) {
  throw std::runtime_error(
      fmt::format("an event that sets unknowns follows another within rounding, at t = {:.10g}", t));
}

// The same function may have infinitely many events up to a time, behind which there is no solution.
void require_later(double t, double before) {
  constexpr double shortest = 1e-9;  // relative
  if (before > 0.0 && t - before < shortest * t) reject_next(t);
}

}  // namespace

ResetLocator::ResetLocator(const Problem& problem)
    : problem_(problem), sizes_(taylor_part(problem, 0.0).cwiseAbs()) {
  const Vec start = taylor_part(problem, 0.0);
  for (std::size_t k = 0; k < problem.resets.size(); ++k) {
    const double value = problem.resets[k].value(0.0, start);
    const bool has_side = std::abs(value) > of_noise * noise(k, 0.0, start);
    sides_.push_back({.sign = has_side ? sign_of(value) : 0, .origin = value});
    last_.push_back(0.0);
  }
}

bool ResetLocator::counts(std::size_t k, int sign) const {
  const auto crossing = problem_.resets[k].crossing;
  return crossing == Crossing::either || (crossing == Crossing::rising) == (sign > 0);
}

// What rounding errors, and those of interpolation, do to the value.
double ResetLocator::noise(std::size_t k, double t, const Vec& y) const {
  constexpr double rounding = 1e-11;
  const auto& value = problem_.resets[k].value;
  const double here = value(t, y);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    Vec moved = y;
    moved[i] += rounding * std::max(sizes_[i], std::abs(y[i]));
    sum += std::abs(value(t, moved) - here);
  }
  return sum;
}

// Whether the value is another one for y far away, or not known there.
bool ResetLocator::depends_on_y(std::size_t k, double t, const Vec& y) const {
  const auto& value = problem_.resets[k].value;
  const Vec far = Vec::LinSpaced(y.size(), 1.0, 1.5).cwiseProduct(Vec::Ones(y.size()) + sizes_);
  for (const double factor : {-3.7, -0.6, 0.3, 1.9})
    if (!(value(t, factor * far) == value(t, y))) return true;
  return noise(k, t, y) > 0.0;
}

// A function without a side gets one where its value is more than noise.
void ResetLocator::leave(Side& side, double value, double noise) {
  const double moved = value - side.origin;
  if (side.direction * moved < -of_noise * noise) side.returns = true;
  if (side.direction == 0 && std::abs(moved) > of_noise * noise) side.direction = sign_of(moved);
  if (std::abs(value) > noise && side.direction != 0) side.sign = sign_of(value);
}

ResetLocator::Crossed ResetLocator::follow(std::size_t k, double from, double to, const Path& y) const {
  const TimeFunction value = [&](double t) { return problem_.resets[k].value(t, y(t)); };
  Crossed found{.at = {}, .side = sides_[k]};
  auto& sign = found.side.sign;
  double before = from;
  walk(value, from, to, [&](double t, double seen) {
    if (sign == 0) {
      leave(found.side, seen, noise(k, t, y(t)));
    } else if (sign_of(seen) == -sign) {
      sign = -sign;
      const double at = last_before_change(value, before, t);
      if (counts(k, sign) && at > 0.0) found.at = at;
    }
    before = t;
    return found.at.has_value();
  });
  return found;
}

std::optional<double> ResetLocator::find(double from, double to, const Path& y) {
  constexpr double simultaneous = 1e-12;  // relative
  if (next_ <= problem_.end) return std::nullopt;
  const double latest = problem_.end * (1.0 - next_to_end);
  std::vector<std::optional<double>> times;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    times.push_back(follow(k, from, to, y).at);
    if (times[k] && *times[k] <= latest) next_ = std::min(next_, *times[k]);
  }
  if (next_ > latest) return std::nullopt;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (times[k] && *times[k] <= next_ * (1.0 + simultaneous)) at_next_.push_back(k);
  return next_;
}

void ResetLocator::accept(double from, double to, const Path& y) {
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (std::ranges::find(at_next_, k) != at_next_.end()) continue;
    const auto [at, side] = follow(k, from, to, y);
    if (side.returns) reject_next(to);
    if (!at) sides_[k] = side;
  }
  for (const double t : {from, (from + to) / 2.0, to}) sizes_ = sizes_.cwiseMax(y(t).cwiseAbs());
}

void ResetLocator::pass(Vec& y) {
  const double t = std::exchange(next_, std::numeric_limits<double>::infinity());
  const auto passed = std::exchange(at_next_, {});
  if (events_.size() == most_events) {
    throw std::runtime_error(
        fmt::format("more than {} events that set unknowns up to t = {}", most_events, t));
  }
  const Vec before = y;
  bool on_y = false;
  for (const auto k : passed) {
    require_later(t, std::exchange(last_[k], t));
    problem_.resets[k].state(t, before, y);
    on_y = on_y || depends_on_y(k, t, before);
  }
  sizes_ = sizes_.cwiseMax(y.cwiseAbs());
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const bool is_passed = std::ranges::find(passed, k) != passed.end();
    const auto& value = problem_.resets[k].value;
    const double now = value(t, y), was = value(t, before);
    if (is_passed && !depends_on_y(k, t, before)) {
      sides_[k].sign = -sides_[k].sign;
    } else if (is_passed || now != was) {
      const bool has_side = now != was && std::abs(now) > of_noise * noise(k, t, y);
      sides_[k] = {.sign = has_side ? sign_of(now) : 0, .origin = now};
    }
  }
  events_.push_back({t, y - before, on_y});
}

std::optional<ResetEvent> ResetLocator::next_to(double end, const Path& y) const {
  const double behind = end * (1.0 + next_to_end);
  const Vec at_end = y(end);
  std::optional<ResetEvent> found;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto& [value, crossing, state] = problem_.resets[k];
    const bool on_y = depends_on_y(k, end, at_end);
    const int sign = sign_of(on_y ? value(behind, y(behind)) : value(end, at_end));
    if (sides_[k].sign == 0 || sign != -sides_[k].sign || !counts(k, sign)) continue;
    Vec after = at_end;
    state(end, at_end, after);
    if (!found) found = ResetEvent{end, Vec::Zero(after.size()), true};
    found->jump = found->jump.cwiseAbs().cwiseMax((after - at_end).cwiseAbs());
  }
  return found;
}

}  // namespace fde::reference
