#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "spectral/panel_solution.hpp"
#include "spectral/panel_solver.hpp"

namespace fde {

// A problem solved by collocation on panels that find their lengths.
//
// Time between two jumps is halved until a panel passes: Newton's method converges, the last Legendre
// coefficients of the drives are below what is allowed, and the drives go on from the panel before. So panels
// shrink towards a start that is a power of t, where each is as long as its distance from it, and wherever
// the solution turns quickly, or reaches a switch: there panels begin anew as behind a jump. What lies in the
// past of a panel comes from the tree.
class PanelMarch {
 public:
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
  double width_ = 1.0;  // of the next panel at most, in units of its segment
  Attempt tried_{};     // the last one on this segment that did not pass
  enum class Going { on, switched, over };
  Going going_ = Going::on;    // otherwise blocks that are begun end where they are
  std::vector<bool> sides_{};  // on which the run is of each switch
  double switched_at_ = -1.0;  // last
  int returns_ = 0;            // to a switch at once, one after the other
  Vec last_drives_;            // at the end of the panel before; empty: not known
};

}  // namespace fde
