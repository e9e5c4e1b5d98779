// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/adaptive_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/rules/adaptive/dense_output.hpp"
#include "fdebench/schemes/rules/adaptive/step_control.hpp"

namespace fde {
namespace {

// t + length, rounded to a multiple of a small part of the length, so that steps of equal length remain equal
// in floating point.
double time_after(double t, double length) {
  const double unit = std::ldexp(1.0, std::ilogb(length) - 12);
  const double next = std::nearbyint((t + length) / unit) * unit;
  return t / unit < 0x1p52 && next > t ? next : t + length;
}

// The ends of the intervals on which the right-hand side is smooth; the last is the end. An interval ends one
// floating-point number before its breaking point.
std::vector<double> stretches(const Problem& problem) {
  std::vector<double> ends;
  for (const double jump : breaking_points(problem)) {
    if (jump < problem.end) ends.push_back(std::nextafter(jump, 0.0));
  }
  ends.push_back(problem.end);
  return ends;
}

class AdaptiveSolver {
 public:
  AdaptiveSolver(const Problem& problem, const Tolerance& accuracy, const Options& options,
                 const StepperFactory& make)
      : problem_(problem),
        accuracy_(accuracy),
        has_algebraic_rows_(has_algebraic_rows(problem)),
        run_(problem, options),
        blow_up_(run_.start()) {
    const auto ends = stretches(problem);
    const double first = initial_step_size(problem, accuracy, run_);
    constexpr double shorter = 1e-4;  // rules with corrections may need less than the rectangle rule
    shortest_ = std::min(shorter * first, std::numeric_limits<double>::epsilon() * ends.front());
    steps_ = make(run_, shortest_);
    control_ = PiController(steps_->rate(), std::min(first, ends.front()));
    sides_ = switch_signs(problem, 0.0, run_.start());
    if (options.output_times.empty()) dense_ = std::make_shared<DenseOutput>(problem);
  }

  Trajectory solve() {
    const StateArchiver state = [this](Archive& archive) { this->state(archive); };
    run_.resume_from_checkpoint(state);
    for (const double end : stretches(problem_)) {
      if (end < interval_end_) continue;
      if (interval_end_ < end && time_ > 0.0 && !cross_jump(just_after(time_))) break;
      interval_end_ = end;
      for (bool continues = true; continues && time_ < end; continues = step_towards(end))
        run_.offer_checkpoint(state);
      if (time_ < end) break;
    }
    run_.cost().history_bytes = steps_->bytes();
    run_.cost().rejected_steps = rejected_steps_;
    run_.cost().linear_solver = steps_->linear_solver();
    auto path = run_.finish();
    if (dense_ && time_ > 0.0) path.dense_output = [dense = dense_](double t) { return dense->at(t); };
    return path;
  }

 private:
  void state(Archive& archive) {
    archive(time_, interval_end_, steps_, control_, rejected_steps_, sides_, last_switch_time_,
            returns_to_switch_, is_first_step_, blow_up_);
    if (dense_) archive(*dense_);
  }

  // The second floating-point number after t: past a jump next to t.
  [[nodiscard]] double just_after(double t) const {
    return std::nextafter(std::nextafter(t, problem_.end), problem_.end);
  }

  // Steps over a jump to t and restarts the rule there, with a step size that is short compared with t.
  bool cross_jump(double t) {
    constexpr double short_step = 1e-6;
    steps_->extrapolate_over_jump(run_, t);
    if (!accept_step(t)) return false;
    steps_->restart(run_);
    blow_up_.restart();
    is_first_step_ = true;
    control_ = PiController(steps_->rate(), short_step * t);
    return true;
  }

  // Takes one step. Returns false if the run is over.
  bool step_towards(double end) {
    constexpr double nearly = 0.99, within_from = 1e-14;
    for (;;) {
      double t = next_time(end);
      if (const double ahead = time_to_switch(t); ahead < t - time_) {
        if (ahead <= switch_tolerance()) return step_over_switch();
        t = time_ + nearly * ahead;
      }
      double error = steps_->attempt(run_, t);
      const double length = t - time_;
      if (error < no_solution && switch_signs(problem_, t, steps_->result()) != sides_) {
        if (length <= switch_tolerance()) return step_over_switch();
        error = no_solution;
      }
      if (is_first_step_ && has_algebraic_rows_ && error <= 1.0 && length > within_from * problem_.end)
        error = std::max(error, dense_output_error(t));
      const bool unasked = time_ == 0.0 && error < no_solution &&
                           exempt_from_relative_tolerance(problem_, run_.start(), length / problem_.end);
      if (control_.update(unasked ? std::min(error, 1.0) : error, length)) return accept_inside_domain(t);
      ++rejected_steps_;
      if (length <= shortest_step()) return handle_smallest_step(error, t, end);
      if (!run_.out_of_budget()) continue;
      run_.fail(SolveStatus::out_of_budget, t);
      return false;
    }
  }

  // Called where no step is short enough for the error test. A jump of f that Problem::jump_times does not
  // contain can be the reason: the test counts the error of the step up to the jump as one that all steps
  // make. In that case the run steps over the jump and restarts the rule; otherwise it ends.
  bool handle_smallest_step(double error, double t, double end) {
    const SolveStatus reason = failure_status(error, t);
    if (reason == SolveStatus::step_too_small && time_ > 0.0 && steps_->error_of_jump() <= 1.0)
      return step_over_jump(std::min(time_ + 2.0 * shortest_step(), end), reason);
    run_.fail(reason, t);
    return false;
  }

  // The error within the first step, attempted to t: the distance of its dense output from the result of a
  // step that ends there, in units of the tolerance. If a multiplier is singular at the start, it leaves an
  // error in the rows on which it acts, and the constraint removes this error at the end of the step only.
  // For an unknown that only a constraint determines, no other test of a first step shows its error.
  double dense_output_error(double t) {
    constexpr double share = 0.3;
    const double between = time_ + share * (t - time_);
    const Vec within = steps_->dense_output(between), limit = steps_->limits();
    if (steps_->attempt(run_, between) == no_solution) return no_solution;
    double error = 0.0;
    for (Eigen::Index i = 0; i < within.size(); ++i) {
      const double y = steps_->result()[i], off = std::abs(within[i] - y);
      const double allowed =
          problem_.is_algebraic(i) ? limit[i] : accuracy_.atol + accuracy_.rtol * std::abs(y);
      if (off > 0.0) error = std::max(error, off / allowed);
    }
    steps_->attempt(run_, t);
    return error;
  }

  // The end of the next step. The last two steps before `end` have about the same length.
  [[nodiscard]] double next_time(double end) const {
    const double left = end - time_, length = std::min(control_.length(), longest_step(problem_, time_));
    if (left <= 1.001 * length) return end;
    return left < 2.0 * length ? time_ + left / 2.0 : time_after(time_, length);
  }

  // Accepts the step attempted to t. If its result is outside the domain, accepts a step up to the edge of
  // the domain and ends the run.
  bool accept_inside_domain(double t) {
    const auto outside = [&](double at, In y) { return !problem_.domain.contains(at, y); };
    if (!outside(t, steps_->result())) return accept_step(t);
    const auto [inside, beyond] = bisect(
        outside, [&](double at) { return steps_->dense_output(at); }, t);
    if (inside > time_ && steps_->attempt(run_, inside) < no_solution) accept_step(inside);
    run_.fail(SolveStatus::left_domain, beyond);
    return false;
  }

  // Bisection: the neighbouring floating-point numbers between which holds(t, y(t)) becomes true.
  // Precondition: it is true at t.
  template <typename Holds, typename Path>
  std::pair<double, double> bisect(Holds holds, Path y, double t) {
    double before = time_, behind = t;
    for (;;) {
      const double middle = before + (behind - before) / 2.0;
      if (middle <= before || middle >= behind) return {before, behind};
      (holds(middle, y(middle)) ? behind : before) = middle;
    }
  }

  // Time until the first switch that is passed before t if f is extrapolated from the step before; infinity:
  // none is passed.
  double time_to_switch(double t) {
    const auto ahead = [&](double at) { return steps_->extrapolate(at); };
    const auto switched = [&](double at, In y) { return switch_signs(problem_, at, y) != sides_; };
    if (problem_.switching_functions.empty() || !switched(t, ahead(t)))
      return std::numeric_limits<double>::infinity();
    return bisect(switched, ahead, t).first - time_;
  }

  // Steps over a switch next to the last accepted time and restarts the rule.
  bool step_over_switch() {
    return step_over_jump(std::min(time_ + 2.0 * switch_tolerance(), problem_.end), SolveStatus::sliding);
  }

  // Steps over a jump of f to t and restarts the rule. The run ends if no step was possible since the last
  // switch. It also ends if it has returned to a switch many times at once: the solution slides along the
  // switch and does not exist beyond.
  bool step_over_jump(double t, SolveStatus if_stuck) {
    constexpr int most_returns = 8;
    constexpr double at_once = 1e-9;  // of the time
    returns_to_switch_ = time_ - last_switch_time_ <= at_once * time_ ? returns_to_switch_ + 1 : 0;
    if (last_switch_time_ == time_ || returns_to_switch_ > most_returns) {
      run_.fail(last_switch_time_ == time_ ? if_stuck : SolveStatus::sliding, t);
      return false;
    }
    sides_ = switch_signs(problem_, t, steps_->extrapolate(t));
    if (!cross_jump(t)) return false;
    last_switch_time_ = time_;
    return true;
  }

  // Time from a switch at which it counts as reached, so that rounding in the memory term does not decide on
  // which side y is.
  [[nodiscard]] double switch_tolerance() const {
    constexpr double part = 1e-12;  // of the time
    return std::max(shortest_, part * time_);
  }

  [[nodiscard]] double shortest_step() const {
    return std::max(shortest_, 4.0 * std::numeric_limits<double>::epsilon() * time_);
  }

  bool accept_step(double t) {
    const bool accepted =
        run_.accept(t, steps_->result(), [&](double between) { return steps_->dense_output(between); });
    // The step in which an event has ended the run is accepted too: the dense output up to the event needs
    // it.
    if (!accepted && !run_.ended_by_event()) return false;
    steps_->accept();
    is_first_step_ = false;
    if (dense_) dense_->add(t, steps_->derivative_polynomials(), steps_->interpolated_rows());
    blow_up_.accept_step(t, steps_->result());
    time_ = t;
    return accepted;
  }

  // Why no step to t is possible, however short.
  SolveStatus failure_status(double error, double t) {
    const Vec& y = steps_->result();
    const bool finite = y.allFinite();
    if (finite && !problem_.domain.contains(time_, y)) return SolveStatus::left_domain;
    if (blow_up_.is_near(time_)) return SolveStatus::blow_up;
    if (error != no_solution) return SolveStatus::step_too_small;
    return finite && run_.rhs(t, y).allFinite() ? SolveStatus::not_converged : SolveStatus::non_finite;
  }

  const Problem& problem_;
  const Tolerance accuracy_;
  const bool has_algebraic_rows_;
  Run run_;
  BlowUpDetector blow_up_;
  double shortest_ = 0.0, time_ = 0.0;
  bool is_first_step_ = true;  // after the start or a jump
  double interval_end_ = 0.0;  // end of the present smooth interval; 0: not begun
  std::unique_ptr<AdaptiveStepper> steps_;
  std::shared_ptr<DenseOutput> dense_;  // if all times are requested
  PiController control_{1.0, 1.0};
  std::int64_t rejected_steps_ = 0;
  std::vector<bool> sides_{};       // the side of each switch on which the solution is
  double last_switch_time_ = -1.0;  // time of the last switch
  int returns_to_switch_ = 0;       // returns to a switch at once
};

}  // namespace

Trajectory solve_adaptively(const Problem& problem, const Tolerance& accuracy, const Options& options,
                            const StepperFactory& make) {
  return AdaptiveSolver(problem, accuracy, options, make).solve();
}

}  // namespace fde
