#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "spectral/panel_solution.hpp"
#include "spectral/panel_solver.hpp"

namespace fde {

// Solves a problem by collocation on panels of adaptive length, for the functions x_k of DrivenRows.
//
// The interval between two jumps is halved until a panel is accepted: Newton's method converges, the last
// Legendre coefficients of the x_k are below the tolerance, and the x_k continue those of the panel before.
// So panels shrink towards a start where the solution behaves like a power of t, each as long as its distance
// from the start, and wherever the solution varies quickly. They also shrink towards a switch, where a new
// segment begins as after a jump. The memory term of a panel is computed from the tree (PastSum).
class PanelMarch {
 public:
  // Problem and options must outlive this object.
  PanelMarch(const Problem& problem, const Accuracy& accuracy, const Options& options);

  Trajectory solve();

 private:
  using Sources = PastSum::Sources;

  void solve_between(double start, double end);
  std::unique_ptr<PastBlock> visit(const TimeBlock& block, const Matrix& smooth, const Sources& near);
  std::unique_ptr<PastBlock> attempt(const TimeBlock& block, const Matrix& smooth, const Sources& near);
  std::unique_ptr<PastBlock> take(const TimeBlock& block, const PanelTask& task, PanelValues solved);
  std::unique_ptr<PastBlock> lead_over_switch(const TimeBlock& block, const PanelTask& task);
  [[nodiscard]] bool reaches_switch(const TimeBlock& panel, const PanelTask& task, const Matrix& rows) const;
  [[nodiscard]] std::unique_ptr<PastBlock> joined(const TimeBlock& block, std::unique_ptr<PastBlock> older,
                                                  std::unique_ptr<PastBlock> newer) const;
  [[nodiscard]] PanelTask task_on(const TimeBlock& panel, const Matrix& smooth, const Sources& near);
  [[nodiscard]] Matrix guess_on(const PanelTask& task);
  [[nodiscard]] Vec effects_of(const TimeBlock& panel, const PanelTask& task, const PanelValues& solved,
                               const Matrix& of_drives, const Vec& allowed);
  [[nodiscard]] double remembered_unit(const TimeBlock& panel, Eigen::Index row) const;
  [[nodiscard]] double break_before(const TimeBlock& panel, const PanelTask& task, const PanelValues& solved,
                                    const Vec& allowed);
  static double needed_share(const Vec& effects);
  struct Attempt {
    double from, width, doubt;
  };
  [[nodiscard]] bool left_by_rounding(const TimeBlock& panel, double doubt) const;
  [[nodiscard]] double rate_at_start(const Attempt& before) const;
  void shorten(const TimeBlock& block, double doubt);
  void lengthen(const TimeBlock& panel, double needed_share);
  void accept(const PastBlock& panel);

  const Problem& problem_;
  std::shared_ptr<PanelSolution> solution_;
  Run run_;
  PanelSolver solver_;
  double width_ = 1.0;  // largest width of the next panel, in units of its segment
  Attempt tried_{};     // the last rejected panel of this segment
  enum class Going { on, switched, over };
  Going going_ = Going::on;    // otherwise the recursion over blocks stops
  std::vector<bool> sides_{};  // the side of each switch on which the solution is
  double switched_at_ = -1.0;  // time of the last switch
  int returns_ = 0;            // successive returns to a switch at once
  Vec last_drives_;            // at the end of the panel before; empty: not known
};

}  // namespace fde
