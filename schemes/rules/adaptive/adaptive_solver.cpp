// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/adaptive_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/rules/adaptive/dense_output.hpp"
#include "fdebench/schemes/rules/adaptive/step_control.hpp"
#include "fdebench/schemes/stepping/stepper.hpp"
#include "fdebench/schemes/stepping/zeros_within_step.hpp"

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
// floating-point number before its breaking point, also before a jump at the end.
std::vector<double> stretches(const Problem& problem) {
  std::vector<double> ends;
  for (const double time : breaking_points(problem)) {
    if (time < problem.end || (time == problem.end && std::ranges::binary_search(problem.jump_times, time)))
      ends.push_back(std::nextafter(time, 0.0));
  }
  ends.push_back(problem.end);
  return ends;
}

// Steps whose sizes keep an estimated error below the tolerance (Hairer, Norsett & Wanner, Solving Ordinary
// Differential Equations I, section II.4), from one jump or switch of the right-hand side to the next.
class ControlledStepper final : public Stepper {
 public:
  ControlledStepper(const Problem& problem, const Tolerance& accuracy, const Options& options,
                    const AdaptiveRuleFactory& make)
      : Stepper(problem, options),
        accuracy_(accuracy),
        has_algebraic_rows_(has_algebraic_rows(problem)),
        interval_ends_(stretches(problem)),
        blow_up_(run_.start()) {
    const double first = initial_step_size(problem, accuracy, run_);
    constexpr double shorter = 1e-4;  // rules with corrections may need less than the rectangle rule
    shortest_ = std::min(shorter * first, std::numeric_limits<double>::epsilon() * interval_ends_.front());
    rule_ = make(run_, shortest_);
    control_ = PiController(rule_->rate(), std::min(first, interval_ends_.front()));
    sides_ = switch_signs(problem, 0.0, run_.start());
    if (options.output_times.empty() || options.wants_past) dense_ = std::make_shared<DenseOutput>(problem);
  }

  [[nodiscard]] bool is_at_end() const { return time_ >= problem_.end; }

  StepOutcome advance() {
    if (left_domain_at_) return {*left_domain_at_, SolveStatus::left_domain};
    if (time_ < interval_end_) return step_towards(interval_end_);
    interval_end_ = *std::ranges::upper_bound(interval_ends_, interval_end_);
    return time_ > 0.0 ? cross_jump(just_after(time_)) : step_towards(interval_end_);
  }

  [[nodiscard]] const Vec& result() const { return rule_->result(); }
  [[nodiscard]] const StepInterpolant* interpolant() const { return &within_; }
  // Newton's method asks for the values of the same times again and again.
  void at(double t, Out y) {
    const auto found = std::ranges::find(looked_up_, t, &LookedUp::t);
    auto& [time, value] =
        found == looked_up_.end() ? looked_up_[next_looked_up_++ % looked_up_.size()] : *found;
    if (std::exchange(time, t) != t) value = dense_->at(t);
    y = value;
  }

  void accept(double t) {
    if (crosses_jump_) rule_->evaluate_behind_jump(run_);
    rule_->accept();
    is_first_step_ = false;
    if (dense_) {
      dense_->add(t, rule_->derivative_polynomials(), rule_->interpolated_rows(), rule_->slopes_left_out());
    }
    blow_up_.accept_step(t, rule_->result());
    time_ = t;
    if (std::exchange(crosses_jump_, false) && !run_.ended_by_event()) restart();
  }

  void state(Archive& archive) {
    archive(time_, interval_end_, rule_, control_, rejected_steps_, sides_, last_switch_time_,
            returns_to_switch_, samples_left_, other_side_, is_first_step_, blow_up_, left_domain_at_);
    if (dense_) archive(*dense_);
  }

  void finish(Trajectory& path) {
    path.cost.history_bytes = rule_->bytes();
    path.cost.rejected_steps = rejected_steps_;
    path.cost.linear_solver = rule_->linear_solver();
    if (dense_ && time_ > 0.0) path.dense_output = [dense = dense_](double t) { return dense->at(t); };
  }

 private:
  // The second floating-point number after t: past a jump next to t.
  [[nodiscard]] double just_after(double t) const {
    return std::nextafter(std::nextafter(t, problem_.end), problem_.end);
  }

  // Steps over a jump to t, where accept() restarts the rule.
  StepOutcome cross_jump(double t) {
    rule_->extrapolate_over_jump(t);
    crosses_jump_ = true;
    return {t};
  }

  // Restarts the rule after a jump, with a step size that is short compared with the time.
  void restart() {
    constexpr double short_step = 1e-6;
    rule_->restart(run_);
    sides_ = switch_signs(problem_, time_, rule_->result());  // y may have jumped
    blow_up_.restart();
    is_first_step_ = true;
    control_ = PiController(rule_->rate(), short_step * time_);
  }

  // Attempts steps until one is within the tolerance.
  StepOutcome step_towards(double end) {
    constexpr double nearly = 0.99, within_from = 1e-14;
    const Vec start = sides_.empty() ? Vec() : y_at_step_start();
    if (time_ >= other_side_) other_side_ = std::numeric_limits<double>::infinity();
    for (;;) {
      double t = std::min(next_time(end), other_side_);
      if (const double ahead = time_to_switch(t); ahead < t - time_) {
        if (ahead <= switch_tolerance()) return step_over_switch();
        t = time_ + nearly * ahead;
      }
      double error = rule_->attempt(run_, t);
      const double length = t - time_;
      if (error < no_solution && switch_signs(problem_, t, rule_->result()) != sides_) {
        if (length <= switch_tolerance()) return step_over_switch();
        error = no_solution;
      }
      if (is_first_step_ && has_algebraic_rows_ && error <= 1.0 && length > within_from * problem_.end)
        error = std::max(error, dense_output_error(t));
      const bool unasked = time_ == 0.0 && error < no_solution &&
                           exempt_from_relative_tolerance(problem_, run_.start(), length / problem_.end);
      if (error <= 1.0 || unasked) {
        if (const auto other = switch_within(start, t)) {
          other_side_ = *other;
          ++rejected_steps_;
          continue;
        }
      }
      if (control_.update(unasked ? std::min(error, 1.0) : error, length)) return inside_domain(t);
      ++rejected_steps_;
      if (length <= shortest_step()) return handle_smallest_step(error, t, end);
      if (run_.out_of_budget()) return {t, SolveStatus::out_of_budget};
    }
  }

  // Called where no step is short enough for the error test. A jump of f that Problem::jump_times does not
  // contain can be the reason: the test counts the error of the step up to the jump as one that all steps
  // make. In that case the run steps over the jump and restarts the rule; otherwise it ends.
  StepOutcome handle_smallest_step(double error, double t, double end) {
    const SolveStatus reason = failure_status(error, t);
    if (reason == SolveStatus::step_too_small && time_ > 0.0 && rule_->error_of_jump() <= 1.0)
      return step_over_jump(std::min(time_ + 2.0 * shortest_step(), end), reason);
    return {t, reason};
  }

  // The error within the first step, attempted to t: the distance of its dense output from the results of
  // steps that end there, in units of the tolerance. If a multiplier is singular at the start, it leaves an
  // error in the rows on which it acts, and the constraint removes this error at the end of the step only.
  // For an unknown that only a constraint determines, no other test of a first step shows its error.
  double dense_output_error(double t) {
    constexpr std::array shares{0.03, 0.3};
    std::vector<Vec> within;
    for (const double share : shares) within.push_back(rule_->dense_output(time_ + share * (t - time_)));
    const Vec limit = rule_->limits();
    double error = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      if (rule_->attempt(run_, time_ + shares[k] * (t - time_)) == no_solution) return no_solution;
      const Vec& y = rule_->result();
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        const double off = std::abs(within[k][i] - y[i]);
        const double allowed =
            problem_.is_algebraic(i) ? limit[i] : accuracy_.atol + accuracy_.rtol * std::abs(y[i]);
        if (off > 0.0) error = std::max(error, off / allowed);
      }
    }
    rule_->attempt(run_, t);
    return error;
  }

  [[nodiscard]] const Vec& y_at_step_start() const { return time_ > 0.0 ? rule_->result() : run_.start(); }

  // The end of the next step. The last two steps before `end` have about the same length.
  [[nodiscard]] double next_time(double end) const {
    const double left = end - time_, length = std::min(control_.length(), longest_step(problem_, time_));
    if (left <= 1.001 * length) return end;
    return left < 2.0 * length ? time_ + left / 2.0 : time_after(time_, length);
  }

  // The step attempted to t. If its result is outside the domain, a step up to the edge of the domain, where
  // the run ends.
  StepOutcome inside_domain(double t) {
    const auto outside = [&](double at, In y) { return !problem_.domain.contains(at, y); };
    if (!outside(t, rule_->result())) return {t};
    const auto [inside, beyond] = bisect(
        outside, [&](double at) { return rule_->dense_output(at); }, t);
    if (inside <= time_ || !(rule_->attempt(run_, inside) < no_solution))
      return {beyond, SolveStatus::left_domain};
    left_domain_at_ = beyond;
    return {inside};
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
    const auto ahead = [&](double at) { return rule_->extrapolate(at); };
    const auto switched = [&](double at, In y) { return switch_signs(problem_, at, y) != sides_; };
    if (problem_.switching_functions.empty() || !switched(t, ahead(t)))
      return std::numeric_limits<double>::infinity();
    return bisect(switched, ahead, t).first - time_;
  }

  // A time within the step attempted to t, from y = start, at which a switch has another side than at both
  // ends.
  std::optional<double> switch_within(const Vec& start, double t) {
    constexpr std::array shares{0.01, 0.1, 0.35, 0.6, 0.85};  // of the step
    if (sides_.empty()) return std::nullopt;
    std::vector<double> times{time_};
    for (const double share : shares)
      if (const double at = time_ + share * (t - time_); at > times.back() && at < t) times.push_back(at);
    times.push_back(t);
    const auto y = [&](double at) -> Vec {
      if (at == time_) return start;
      return at == t ? rule_->result() : rule_->dense_output(at);
    };
    return time_on_other_side(problem_, sides_, times, y, samples_left_);
  }

  // Steps over a switch next to the last accepted time and restarts the rule.
  StepOutcome step_over_switch() {
    return step_over_jump(std::min(time_ + 2.0 * switch_tolerance(), problem_.end), SolveStatus::sliding);
  }

  // Steps over a jump of f to t and restarts the rule. The run ends if no step was possible since the last
  // switch. It also ends if it has returned to a switch many times at once: the solution slides along the
  // switch and does not exist beyond.
  StepOutcome step_over_jump(double t, SolveStatus if_stuck) {
    constexpr int most_returns = 8;
    constexpr double at_once = 1e-9;  // of the time
    returns_to_switch_ = time_ - last_switch_time_ <= at_once * time_ ? returns_to_switch_ + 1 : 0;
    if (last_switch_time_ == time_) return {t, if_stuck};
    if (returns_to_switch_ > most_returns) return {t, SolveStatus::sliding};
    sides_ = switch_signs(problem_, t, rule_->extrapolate(t));
    last_switch_time_ = t;
    return cross_jump(t);
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

  // Why no step to t is possible, however short.
  SolveStatus failure_status(double error, double t) {
    const Vec& y = rule_->result();
    const bool finite = y.allFinite();
    if (finite && !problem_.domain.contains(time_, y)) return SolveStatus::left_domain;
    if (blow_up_.is_near(time_)) return SolveStatus::blow_up;
    if (error != no_solution) return SolveStatus::step_too_small;
    return finite && run_.rhs(t, y).allFinite() ? SolveStatus::not_converged : SolveStatus::non_finite;
  }

  struct LookedUp {
    double t = -1.0;
    Vec value{};
  };

  const Tolerance accuracy_;
  const bool has_algebraic_rows_;
  const std::vector<double> interval_ends_;
  BlowUpDetector blow_up_;
  double shortest_ = 0.0, time_ = 0.0;
  bool is_first_step_ = true;               // after the start or a jump
  double interval_end_ = 0.0;               // end of the present smooth interval; 0: not begun
  bool crosses_jump_ = false;               // the step to be accepted steps over a jump
  std::optional<double> left_domain_at_{};  // just outside the domain; its edge has been reached
  std::unique_ptr<AdaptiveRule> rule_;
  std::shared_ptr<DenseOutput> dense_;  // if all times are requested, or earlier values
  std::vector<LookedUp> looked_up_ = std::vector<LookedUp>(8);  // the last earlier values
  std::size_t next_looked_up_ = 0;
  PiController control_{1.0, 1.0};
  std::int64_t rejected_steps_ = 0;
  std::vector<bool> sides_{};       // the side of each switch on which the solution is
  double last_switch_time_ = -1.0;  // time of the last switch
  int returns_to_switch_ = 0;       // returns to a switch at once
  std::uint64_t samples_left_ = most_samples / 10;
  // Where a switch has another side, between two zeros that lie ahead; infinity: none is known.
  double other_side_ = std::numeric_limits<double>::infinity();
  const StepInterpolant within_{[this](double t) { return rule_->dense_output(t); }};
};

}  // namespace

Trajectory solve_adaptively(const Problem& problem, const Tolerance& accuracy, const Options& options,
                            const AdaptiveRuleFactory& make) {
  return integrate(ControlledStepper(problem, accuracy, options, make));
}

}  // namespace fde
