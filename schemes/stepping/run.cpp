// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/run.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde {

namespace {

// x - x is 0 where x is finite, otherwise NaN.
bool all_finite(const Vec& y) {
  return holds_for_each_row(y.size(),
                            [values = y.data()](Eigen::Index i) { return values[i] - values[i] == 0.0; });
}

// The sign of the scalar product of the minors of the gradients at a and of the reactions at b.
int sign_between(const ConstraintMatrices& a, const ConstraintMatrices& b) {
  const double determinant = (a.gradients * b.reactions).determinant();
  return determinant > 0.0 ? 1 : determinant < 0.0 ? -1 : 0;
}

}  // namespace

Run::Run(const Problem& problem, const Options& options, int steps)
    : problem_(problem), options_(options), start_(taylor_part(problem, 0.0)), f_(problem.size()) {
  if (!options.events.empty()) events_.emplace(options.events, start_);
  if (problem.domain.constraints) rank_.emplace(problem, start_);
  if (options.wants_past) results_.emplace(start_, breaking_points(problem));
  path_.cost = {.rhs_calls = 0,
                .newton_iterations = 0,
                .history_bytes = 0,
                .components = static_cast<int>(problem.size())};
  const std::size_t expected =
      options.output_times.empty() ? static_cast<std::size_t>(steps) + 1 : options.output_times.size();
  path_.times.reserve(expected);
  path_.y.resize(problem.size(), static_cast<Eigen::Index>(expected));
  if (!is_two_sided(problem)) record(0.0, start_);
}

const Vec& Run::rhs_of_increments(double t, In z) {
  ++*path_.cost.rhs_calls;
  problem_.increments.rhs(t, z, f_);
  return f_;
}

bool Run::accept_located(double t, const Vec& y, const StepInterpolant* within) {
  if (within == nullptr)
    throw std::invalid_argument("events: are located by schemes that take an accuracy, not over a grid");
  const double before = path_.last_time;
  if (!check_step(t, y)) return false;
  if (events_ && ends_at_event(before, t, y, *within)) return false;
  // Behind a jump or a switch, where a solution of small order changes at once, steps may be shorter than the
  // rounding error of t.
  if (t > before) record_step(before, t, y, *within);
  return true;
}

bool Run::ends_at_event(double before, double t, const Vec& y, const StepInterpolant& within) {
  const auto found = events_->step(t, y, within);
  path_.events.insert(path_.events.end(), found.begin(), found.end());
  if (found.empty() || !options_.events[found.back().event].terminal) return false;
  path_.status = SolveStatus::terminal_event;
  path_.last_time = found.back().t;
  record_step(before, found.back().t, found.back().y, within);
  return true;
}

void Run::record_step(double before, double t, const Vec& y, const StepInterpolant& within) {
  if (options_.observer) options_.observer(t, y);
  if (options_.output_times.empty()) store(t, y);
  constexpr double rounding = 1e-12;  // of the time at which a last step ends
  const bool last = t >= problem_.end * (1 - rounding) && !ended_by_event();
  const double until = last ? std::max(t, problem_.end) : t;
  for (const auto& at = options_.output_times; next_output_ < at.size() && at[next_output_] <= until;
       ++next_output_) {
    const double output = at[next_output_];
    if (output > before) store(output, output == t ? y : within.at(std::min(output, t)));
  }
}

bool Run::check_step(double t, const Vec& y) {
  const std::int64_t n = t > 0.0 ? path_.steps + 1 : 0;
  const auto& domain = problem_.domain;
  if (!all_finite(y)) {
    fail(SolveStatus::non_finite, t);
  } else if ((domain.margin && !domain.contains(t, y)) ||  // without a margin no view of y is made
             (rank_ && !rank_->is_kept_until(t, y))) {
    fail(SolveStatus::left_domain, t);
  } else if (n >= next_look_ && is_out_of_budget_at(n)) {
    fail(SolveStatus::out_of_budget, t);
  }
  if (path_.status != SolveStatus::finished) return false;
  path_.steps = n;
  path_.last_time = t;
  return true;
}

// Reading the clock at every step would take a third of the time of the cheapest step.
bool Run::is_out_of_budget_at(std::int64_t step) {
  constexpr std::chrono::microseconds interval{100};
  const bool out = out_of_budget();
  const auto now = std::chrono::steady_clock::now();
  if (now - last_look_ < interval) {
    steps_between_looks_ *= 2;
  } else if (steps_between_looks_ > 1) {
    steps_between_looks_ /= 2;
  }
  last_look_ = now;
  next_look_ = step + steps_between_looks_;
  return out;
}

bool Run::resume_from_checkpoint(const StateArchiver& state) {
  return options_.checkpoints != nullptr && options_.checkpoints->resume([&](Archive& archive) {
    this->state(archive);
    state(archive);
  });
}

void Run::offer_checkpoint(const StateArchiver& state) {
  if (options_.checkpoints == nullptr) return;
  options_.checkpoints->offer([&](Archive& archive) {
    this->state(archive);
    state(archive);
  });
}

void Run::state(Archive& archive) {
  archive(path_.steps, path_.last_time, *path_.cost.rhs_calls, *path_.cost.newton_iterations);
  archive.count(next_output_, 0, options_.output_times.size());
  archive.resizable(path_.times);
  archive.first_columns(path_.y, std::ssize(path_.times));
  archive.resizable(path_.events);
  archive(events_, rank_, results_);
}

void Run::fail(SolveStatus ending, double t) {
  path_.status = ending;
  path_.failure_time = t;
}

void Run::fail_without_convergence(double residual) {
  path_.status = SolveStatus::not_converged;
  path_.residual = residual;
}

bool Run::out_of_budget() const {
  report_progress(static_cast<std::size_t>(path_.steps));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin_;
  return taken.count() > options_.budget;
}

void Run::record(double t, const Vec& y) {
  if (options_.observer) options_.observer(t, y);
  if (options_.output_times.empty() || (t >= next_output_from_ && is_output_time(t))) store(t, y);
}

void Run::store(double t, const Vec& y) {
  const auto column = std::ssize(path_.times);
  if (column == path_.y.cols()) path_.y.conservativeResize(Eigen::NoChange, 2 * column + 1);
  path_.y.col(column) = y;
  path_.times.push_back(t);
}

bool Run::is_output_time(double t) {
  constexpr double rounding = 1e-12;
  const auto& at = options_.output_times;
  while (next_output_ < at.size() && at[next_output_] < t * (1 - rounding)) ++next_output_;
  const double next = next_output_ < at.size() ? at[next_output_] : std::numeric_limits<double>::infinity();
  next_output_from_ = next * (1 - 2 * rounding);
  return next <= t * (1 + rounding);
}

Trajectory Run::finish() {
  path_.y.conservativeResize(Eigen::NoChange, std::ssize(path_.times));
  return std::move(path_);
}

std::vector<WeightTable> weight_tables(const Problem& problem, const WeightFamily& family) {
  std::vector<WeightTable> result;
  for (const auto& component : problem.components) result.push_back({&family, component.order});
  return result;
}

ConstraintRank::ConstraintRank(const Problem& problem, In start) : problem_(problem), last_(at(0.0, start)) {}

bool ConstraintRank::is_kept_until(double t, In y) {
  State next = at(t, y);
  if (!is_kept_between(last_, next, 0)) return false;
  last_ = std::move(next);
  return true;
}

bool ConstraintRank::is_kept_between(const State& a, const State& b, int halvings) const {
  constexpr int most = 40;
  const int sign = sign_between(a.constraints, a.constraints);
  if (sign != 0 && sign_between(a.constraints, b.constraints) == sign &&
      sign_between(b.constraints, b.constraints) == sign)
    return true;
  if (halvings == most) return false;
  const State middle = at(0.5 * (a.t + b.t), 0.5 * (a.y + b.y));
  return is_kept_between(a, middle, halvings + 1) && is_kept_between(middle, b, halvings + 1);
}

void ConstraintRank::state(Archive& archive) {
  archive(last_.t, last_.y);
  last_ = at(last_.t, last_.y);
}

}  // namespace fde
