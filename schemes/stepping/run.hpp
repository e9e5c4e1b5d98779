#pragma once

#include <chrono>

#include "stepping/scheme.hpp"

namespace fde {

// What every scheme does besides its formulas: counts rhs calls, keeps the steps asked for, stops at the
// first value that is not finite, at the edge of the problem's domain and at the end of the budget. One
// object a run.
class Run {
 public:
  Run(const Problem& problem, const Grid& grid, const Options& options);

  // f(t, y), counted. Valid until the next call.
  const Vec& rhs(double t, In y);

  // y(0), recorded as step 0. A two-sided problem's is known last: the guess here is not recorded.
  [[nodiscard]] const Vec& start() const { return start_; }

  // Records step n, of a two-sided problem from 0 on. False, and the run is over, when y is not finite or
  // outside the domain, or the budget is spent.
  bool accept(int n, In y);

  // Ends the run before step n has a result.
  void fail(Ending ending) { path_.ending = ending; }

  // Whether the run has taken longer than it may; looks at the clock.
  [[nodiscard]] bool out_of_budget() const;

  Cost& cost() { return path_.cost; }
  Trajectory finish();

 private:
  void record(int n, In y);

  const Problem& problem_;
  const Options& options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Vec start_, f_;
  std::size_t next_kept_ = 0;
  Trajectory path_;
};

// The tables of one sum: the same family for every component, each with its own order.
std::vector<WeightTable> tables(const Problem& problem, const WeightFamily& family);

// step_factor of every table, step after step: computed once where all steps are equal.
class StepFactors {
 public:
  StepFactors(std::vector<WeightTable> tables, const Grid& grid);
  const Vec& at(int n);

 private:
  std::vector<WeightTable> tables_;
  Grid grid_;
  Vec factors_;
};

}  // namespace fde
