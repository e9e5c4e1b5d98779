// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fdebench/schemes/rules/spectral/panel_solver.hpp"
#include "fdebench/schemes/rules/spectral/panel_tree.hpp"

namespace fde {

// Solves a problem by collocation on panels of adaptive length, for the functions x_k of IntegratedRows.
//
// The interval between two breaking_points is halved until a panel is accepted: Newton's method converges,
// the last Legendre coefficients of the x_k are below the tolerance, and the x_k continue those of the panel
// before. So panels shrink towards a start where the solution behaves like a power of t, each as long as its
// distance from the start, and wherever the solution varies quickly. They also shrink towards a switch, where
// a new segment begins as after a jump. The memory term of a panel is computed from the tree (MemorySum).
class PanelCollocation {
 public:
  // Problem and options must outlive this object.
  PanelCollocation(const Problem& problem, const Tolerance& accuracy, const Options& options);

  Trajectory solve();

 private:
  using Sources = MemorySum::Sources;

  void solve_between(double start, double end);
  std::unique_ptr<MemoryBlock> solve_block(const TimeBlock& block, const Matrix& smooth, const Sources& near);
  std::unique_ptr<MemoryBlock> attempt_panel(const TimeBlock& block, const Matrix& smooth,
                                             const Sources& near);
  std::unique_ptr<MemoryBlock> accept_panel(const TimeBlock& block, const PanelSystem& task,
                                            PanelValues solved);
  std::unique_ptr<MemoryBlock> step_over_switch(const TimeBlock& block, const PanelSystem& task);
  [[nodiscard]] bool contains_switch(const TimeBlock& panel, const PanelSystem& task,
                                     const Matrix& rows) const;
  [[nodiscard]] std::unique_ptr<MemoryBlock> merged(const TimeBlock& block,
                                                    std::unique_ptr<MemoryBlock> older,
                                                    std::unique_ptr<MemoryBlock> newer) const;
  [[nodiscard]] PanelSystem task_on(const TimeBlock& panel, const Matrix& smooth, const Sources& near);
  [[nodiscard]] Matrix guess_on(const PanelSystem& task);
  [[nodiscard]] Vec errors_by_degree(const TimeBlock& panel, const PanelSystem& task,
                                     const PanelValues& solved, const Matrix& of_unknowns,
                                     const Vec& allowed);
  [[nodiscard]] double velocity_error_unit(const TimeBlock& panel, Eigen::Index row) const;
  [[nodiscard]] double discontinuity_error(const TimeBlock& panel, const PanelSystem& task,
                                           const PanelValues& solved, const Vec& allowed);
  static double needed_fraction(const Vec& effects);
  struct RejectedPanel {
    double from, width, error;
  };
  [[nodiscard]] bool is_rounding_error(const TimeBlock& panel, double error) const;
  [[nodiscard]] double error_rate_at_start(const RejectedPanel& before) const;
  void reject_panel(const TimeBlock& block, double error);
  void set_next_width(const TimeBlock& panel, double needed_fraction);
  void record_panel(const MemoryBlock& panel);

  const Problem& problem_;
  std::shared_ptr<PanelSolution> solution_;
  Run run_;
  PanelSolver solver_;
  double width_ = 1.0;             // largest width of the next panel, in units of its segment
  RejectedPanel last_rejected_{};  // the last rejected panel of this segment
  enum class RunPhase { running, segment_ended, run_ended };
  RunPhase phase_ = RunPhase::running;  // otherwise the recursion over blocks stops
  std::vector<bool> sides_{};           // the side of each switch on which the solution is
  double last_switch_time_ = -1.0;      // time of the last switch
  int returns_to_switch_ = 0;           // successive returns to a switch at once
  Vec last_unknowns_;                   // at the end of the panel before; empty: not known
};

}  // namespace fde
