#pragma once

#include <chrono>

#include "checkpoint/checkpoints.hpp"
#include "stepping/event_search.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// What every scheme that steps does besides its formulas: counts rhs calls, keeps the times asked for, stops
// at the first value that is not finite, at the edge of the problem's domain and at the end of the budget.
// One object a run.
class Run {
 public:
  // Makes room for the results of so many steps; there may be more.
  Run(const Problem& problem, const Options& options, int steps = 0);

  // f(t, y), counted. Valid until the next call.
  const Vec& rhs(double t, In y);

  // y(0), recorded at t = 0. A two-sided problem's is known last: the guess here is not recorded.
  [[nodiscard]] const Vec& start() const { return start_; }

  // Records the result of the step to t > 0, of a two-sided problem from t = 0 on. False, and the run is
  // over, when y is not finite or outside the domain, or the budget is spent. Throws std::invalid_argument
  // where there are events, which a scheme that knows y at its steps alone cannot locate.
  bool accept(double t, In y);
  // The same of a scheme that knows y since the last step: of Options::at, times between are recorded too,
  // and events are located, for which the step is looked at in so many pieces. False also at an event that
  // ends the run; the result then counts up to there.
  bool accept(double t, In y, const std::function<Vec(double)>& between, int pieces = 8);

  // Whether an event has ended the run, within the last step.
  [[nodiscard]] bool ended_by_event() const { return path_.ending == Ending::event; }

  // Options::checkpoints, between two steps: whether the run goes on from a state kept there, and one that
  // may be kept. `state` is that of the scheme; what a Run has is part of it.
  bool resume(const State& state);
  void offer(const State& state);

  // Ends the run where the step to t has no result.
  void fail(Ending ending, double t);
  // The same where Newton's method for all times at once has left this residual.
  void fail_at_once(double residual);

  // Whether the run has taken longer than it may; looks at the clock, and who listens to work hears of it.
  [[nodiscard]] bool out_of_budget() const;

  Cost& cost() { return path_.cost; }
  Trajectory finish();

 private:
  bool goes_on(double t, In y);
  void record_step(double before, double t, In y, const std::function<Vec(double)>& between);
  void state(Archive& archive);
  void record(double t, In y);
  void keep(double t, In y);
  bool asked_for(double t);

  const Problem& problem_;
  const Options& options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Vec start_, f_;
  std::size_t next_at_ = 0;  // of Options::at
  std::optional<EventSearch> events_{};
  Trajectory path_;
};

// The tables of one sum: the same family for every component, each with its own order.
std::vector<WeightTable> tables(const Problem& problem, const WeightFamily& family);

}  // namespace fde
