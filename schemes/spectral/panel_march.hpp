#pragma once

#include <memory>
#include <utility>

#include "spectral/panel_solution.hpp"
#include "spectral/panel_solver.hpp"

namespace fde {

// A problem solved by collocation on panels that find their lengths.
//
// Time between two jumps is halved until a panel passes: Newton's method converges, the last Legendre
// coefficients of the drives are below what is allowed, and the drives go on from the panel before. So panels
// shrink towards a start that is a power of t, where each is as long as its distance from it, and wherever
// the solution turns quickly. What lies in the past of a panel comes from the tree.
class PanelMarch {
 public:
  PanelMarch(const Problem& problem, const Accuracy& accuracy, const Options& options);

  Trajectory solve();

 private:
  using Sources = PastSum::Sources;

  std::unique_ptr<PastBlock> visit(const TimeBlock& block, const Matrix& smooth, const Sources& near);
  std::unique_ptr<PastBlock> attempt(const TimeBlock& block, const Matrix& smooth, const Sources& near);
  [[nodiscard]] std::unique_ptr<PastBlock> joined(const TimeBlock& block, std::unique_ptr<PastBlock> older,
                                                  std::unique_ptr<PastBlock> newer) const;
  [[nodiscard]] PanelTask task_on(const TimeBlock& panel, const Matrix& smooth, const Sources& near);
  [[nodiscard]] Matrix guess_on(const PanelTask& task);
  [[nodiscard]] Vec effects_of(const TimeBlock& panel, const PanelTask& task, const PanelValues& solved,
                               const Matrix& of_drives);
  [[nodiscard]] double unit_of(const PanelTask& task, Eigen::Index row) const;
  [[nodiscard]] bool breaks_off(const PanelTask& task, const PanelValues& solved) const;
  static double needed_share(const Vec& effects);
  void shorten(const TimeBlock& block, double doubt);
  double rate_at_start(double width, double doubt);
  void lengthen(const TimeBlock& panel, double needed_share);
  void accept(const PastBlock& panel);

  const Problem& problem_;
  std::shared_ptr<PanelSolution> solution_;
  Run run_;
  PanelSolver solver_;
  double width_ = 1.0;                         // of the next panel at most, in units of its segment
  std::pair<double, double> tried_{1.0, 0.0};  // the first panel that did not pass last, and its doubt
  bool over_ = false;
  Vec last_drives_;  // at the end of the panel before; empty: not known
};

}  // namespace fde
