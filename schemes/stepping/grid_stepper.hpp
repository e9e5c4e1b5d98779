// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "fdebench/schemes/history/history_kind.hpp"
#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"
#include "fdebench/schemes/stepping/stepper.hpp"

namespace fde {

// The base of a scheme that steps over a grid: `class Euler final : public GridStepper<Euler>`. Its rule is
//   SolveStatus step()          computes y_n at t() in y_, which is y_(n-1) at before(),
//   void rule_state(Archive&)   saves or restores what the rule keeps between two steps beside y_.
// It may redefine start(), accept() and finish().
template <class Rule>
class GridStepper : public Stepper {
 public:
  [[nodiscard]] bool is_at_end() const { return n_ == grid_.steps; }

  StepOutcome advance() {
    before_ = t_;
    t_ = grid_.time(++n_);
    if (!grid_.uniform()) h_ = t_ - before_;
    return {t_, static_cast<Rule*>(this)->step()};
  }

  [[nodiscard]] const Vec& result() const { return *result_; }

  void state(Archive& archive) {
    archive.count(n_, 0, grid_.steps - 1);
    t_ = grid_.time(n_);
    archive(y_);
    static_cast<Rule*>(this)->rule_state(archive);
  }

 protected:
  GridStepper(const Problem& problem, const Grid& grid, const Options& options)
      : Stepper(problem, options, grid.steps), y_(run_.start()), grid_(grid), jumps_(problem, grid) {}
  ~GridStepper() = default;

  void record_history(std::size_t bytes, ChosenHistory history) {
    run_.cost().history_bytes = bytes;
    run_.cost().history = history;
  }

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const GridJumps& jumps() const { return jumps_; }
  [[nodiscard]] int n() const { return n_; }               // the number of the step
  [[nodiscard]] double t() const { return t_; }            // t_n
  [[nodiscard]] double before() const { return before_; }  // t_(n-1)
  [[nodiscard]] double h() const { return h_; }            // t_n - t_(n-1), as Grid::step

  Vec y_;
  const Eigen::Ref<const Vec> solution_{y_};  // made once: a view takes as long as a component
  const Vec* result_ = &y_;                   // what the step delivers, if not y_

 private:
  const Grid grid_;
  const GridJumps jumps_;
  int n_ = 0;
  double t_ = 0.0, before_ = 0.0, h_ = grid_.step();
};

}  // namespace fde
