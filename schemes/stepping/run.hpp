// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/stored_results.hpp"
#include "fdebench/schemes/stepping/checkpoints.hpp"
#include "fdebench/schemes/stepping/event_locator.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Detects that the constraints of a problem (Domain::constraints) lose their rank within a step: what follows
// would be unrelated to the motion. With A the gradients and Q the reactions, det(A(a) Q(b)) is the scalar
// product of the vectors of minors of A at a state a and of Q at a state b (Cauchy & Binet). On a step whose
// minors turn by less than a right angle it has one sign for all pairs of states. Where a step has two signs,
// it is halved along the straight line between its ends. If the signs stay two down to the shortest part, the
// minors pass through 0.
class ConstraintRank {
 public:
  // Precondition: problem.domain.constraints is not empty.
  ConstraintRank(const Problem& problem, In start);

  // Whether the rank is kept from the last state to this one, which is then the last.
  bool is_kept_until(double t, In y);

  void state(Archive& archive);

 private:
  struct State {
    double t;
    Vec y;
    ConstraintMatrices constraints;
  };
  [[nodiscard]] State at(double t, In y) const { return {t, y, problem_.domain.constraints(t, y)}; }
  [[nodiscard]] bool is_kept_between(const State& a, const State& b, int halvings) const;

  const Problem& problem_;
  State last_;
};

// The bookkeeping of a time-stepping run that does not depend on the scheme: counts rhs calls, records the
// output times, and stops at a value that is not finite, outside the domain of the problem, where constraints
// lose their rank and at the end of the budget. One object a run; `problem` and `options` must outlive it.
class Run {
 public:
  // Reserves storage for the results of `steps` steps; more are possible.
  Run(const Problem& problem, const Options& options, int steps = 0);

  // Sets f to f(t, y), counted in Cost::rhs_calls.
  void rhs(double t, In y, Vec& f) {
    ++*path_.cost.rhs_calls;
    problem_.rhs(t, y, f);
  }
  // f(t, y), counted too. The reference is valid until the next call.
  const Vec& rhs(double t, In y) {
    rhs(t, y, f_);
    return f_;
  }
  // The same as a function of the increments. Precondition: the problem has them (IncrementForm).
  const Vec& rhs_of_increments(double t, In z);

  // y(0), which is recorded at t = 0; in a two-sided problem only a guess of it, which is not recorded.
  [[nodiscard]] const Vec& start() const { return start_; }

  // Records the result y of the step to t; t > 0, in a two-sided problem t >= 0. With an interpolant of the
  // step, times of Options::output_times inside the step are recorded too, and events are located. False, and
  // the run has ended, when y is not finite or outside the domain, the budget is spent, or an event ends the
  // run; the result is then valid up to the event. Throws std::invalid_argument where Options::events is not
  // empty and there is no interpolant.
  bool accept(double t, const Vec& y, const StepInterpolant* within = nullptr) {
    if (within != nullptr || events_) return accept_located(t, y, within);
    if (!check_step(t, y)) return false;
    if (results_) results_->add(t, y);
    record(t, y);
    return true;
  }

  // Whether an event has ended the run, within the last step.
  [[nodiscard]] bool ended_by_event() const { return path_.status == SolveStatus::terminal_event; }

  // y at a time from 0 to the last, interpolated between the results. Precondition: Options::wants_past.
  [[nodiscard]] Vec interpolated(double t) const { return results_->at(t); }

  // Between two steps, with Options::checkpoints. resume_from_checkpoint() restores a stored state and
  // returns whether there is one; offer_checkpoint() lets the checkpoints store the present one. `state`
  // archives the state of the scheme; the state of this object is added.
  bool resume_from_checkpoint(const StateArchiver& state);
  void offer_checkpoint(const StateArchiver& state);

  // Ends the run because the step to t has no result.
  void fail(SolveStatus ending, double t);
  // Ends the run because Newton's method for all times at once has not converged, with its last residual.
  void fail_without_convergence(double residual);

  // Whether the run has taken longer than its budget. Reads the clock and reports the number of steps
  // (report_progress), so it throws what a listener throws.
  [[nodiscard]] bool out_of_budget() const;

  // Starts the clock of the budget anew: the construction of the scheme does not count.
  void start_clock() { begin_ = last_look_ = std::chrono::steady_clock::now(); }

  Cost& cost() { return path_.cost; }
  Trajectory finish();

 private:
  bool accept_located(double t, const Vec& y, const StepInterpolant* within);
  bool check_step(double t, const Vec& y);
  // out_of_budget(), which is evaluated about every 0.1 ms.
  bool is_out_of_budget_at(std::int64_t step);
  // Locates events within the step; returns whether one of them has ended the run.
  bool ends_at_event(double before, double t, const Vec& y, const StepInterpolant& within);
  void record_step(double before, double t, const Vec& y, const StepInterpolant& within);
  void state(Archive& archive);
  void record(double t, const Vec& y);
  void store(double t, const Vec& y);
  bool is_output_time(double t);

  const Problem& problem_;
  const Options& options_;
  RowThreads threads_{options_.threads};
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Vec start_, f_;
  std::size_t next_output_ = 0;    // index in Options::output_times of the next output time
  double next_output_from_ = 0.0;  // is_output_time() is false before this time
  std::int64_t next_look_ = 0, steps_between_looks_ = 1;  // at the clock
  std::chrono::steady_clock::time_point last_look_ = begin_;
  std::optional<StoredResults> results_{};  // where the past is wanted
  std::optional<EventLocator> events_{};
  std::optional<ConstraintRank> rank_{};
  Trajectory path_;
};

// The weight tables of one memory sum: the same family for every component, each with its own order.
std::vector<WeightTable> weight_tables(const Problem& problem, const WeightFamily& family);

}  // namespace fde
