// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "fdebench/schemes/rules/spectral/panel_solver.hpp"
#include "fdebench/schemes/rules/spectral/panel_tree.hpp"
#include "fdebench/schemes/stepping/stepper.hpp"
#include "fdebench/schemes/stepping/zeros_within_step.hpp"

namespace fde {

// Solves a problem by collocation on panels of adaptive length, for the functions x_k of IntegratedRows.
//
// The interval between two breaking_points is halved until a panel is accepted: Newton's method converges,
// the last Legendre coefficients of the x_k are below the tolerance, and the x_k continue those of the panel
// before. So panels shrink towards a start where the solution behaves like a power of t, each as long as its
// distance from the start, and wherever the solution varies quickly. They also shrink towards a switch, where
// a new segment begins as after a jump. The memory term of a panel is computed from the tree (MemorySum).
class PanelCollocation final : public Stepper {
 public:
  // Problem and options must outlive this object.
  PanelCollocation(const Problem& problem, const Tolerance& accuracy, const Options& options);

  [[nodiscard]] bool is_at_end() const;
  StepOutcome advance();
  [[nodiscard]] const Vec& result() const { return result_; }
  [[nodiscard]] const StepInterpolant* interpolant() const { return &within_; }
  void at(double t, Out y) const { y = solution_->panels.empty() ? run_.start() : solution_->at(t); }
  void accept(double t);
  static void state(Archive& archive);  // throws std::logic_error: Capabilities::checkpoints is false
  void finish(Trajectory& path);

 private:
  using Sources = MemorySum::Sources;
  // A block whose panels are being solved, with its memory term from before the block: the part that is
  // smooth on it, and the sources of the rest.
  struct OpenBlock {
    TimeBlock block;
    Matrix smooth;
    Sources near;
    std::unique_ptr<MemoryBlock> older{};  // its older half, once that is solved
  };

  void begin_segment();
  void end_segment_at(double t);
  void close_open_blocks();
  [[nodiscard]] bool may_be_panel(const TimeBlock& block) const;
  [[nodiscard]] OpenBlock half_of(const OpenBlock& open, const TimeBlock& block, const Matrix& to_half);
  std::unique_ptr<MemoryBlock> attempt_panel(const OpenBlock& open);
  std::unique_ptr<MemoryBlock> panel_of(const TimeBlock& block, const PanelSystem& task,
                                        const PanelValues& solved);
  void accept_values(const PanelSystem& task, const PanelValues& solved);
  bool passes_over_switch(const MemoryBlock& panel, const PanelSystem& task, const Matrix& rows);
  std::unique_ptr<MemoryBlock> step_over_switch(const TimeBlock& block, const PanelSystem& task);
  PanelValues extrapolated_on(const PanelSystem& task);
  std::unique_ptr<MemoryBlock> panel_over_switch(const TimeBlock& block, const PanelSystem& task,
                                                 const PanelValues& followed);
  [[nodiscard]] bool contains_switch(const TimeBlock& panel, const PanelSystem& task,
                                     const Matrix& rows) const;
  [[nodiscard]] std::unique_ptr<MemoryBlock> merged(const TimeBlock& block,
                                                    std::unique_ptr<MemoryBlock> older,
                                                    std::unique_ptr<MemoryBlock> newer) const;
  [[nodiscard]] PanelSystem task_on(const OpenBlock& open);
  [[nodiscard]] Matrix guess_on(const PanelSystem& task);
  [[nodiscard]] Vec errors_by_degree(const TimeBlock& panel, const PanelSystem& task,
                                     const PanelValues& solved, const Matrix& of_unknowns,
                                     const Vec& allowed);
  [[nodiscard]] double first_panel_unit(const TimeBlock& panel, Eigen::Index row) const;
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

  std::shared_ptr<PanelSolution> solution_;
  PanelSolver solver_;
  std::vector<double> interval_ends_;  // the breaking points and the end, those that are still to come
  double next_start_ = 0.0;            // of the next segment
  std::vector<OpenBlock> open_{};  // the blocks that contain the next panel, each a half of the one before
  std::unique_ptr<MemoryBlock> panel_{};  // the last one, as long as it is in no block
  Vec result_{};
  const StepInterpolant within_;
  double width_ = 1.0;                    // largest width of the next panel, in units of its segment
  RejectedPanel last_rejected_{};         // the last rejected panel of this segment
  bool segment_ends_ = false;             // the next panel begins a segment
  std::optional<StepOutcome> failure_{};  // why there is no next panel
  std::vector<bool> sides_{};             // the side of each switch on which the solution is
  double last_switch_time_ = -1.0;        // time of the last switch
  int returns_to_switch_ = 0;             // successive returns to a switch at once
  int restarts_ = 0;                      // of a segment behind a switch, each farther behind it
  double extrapolated_length_ = 0.0;      // of the next panel, the first of such a segment
  std::uint64_t samples_left_ = most_samples / 10;
  Vec last_unknowns_;  // at the end of the panel before; empty: not known
};

}  // namespace fde
