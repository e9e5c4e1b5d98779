// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/rules/two_sided/side_rule.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The rule of the stepping schemes on a grid, for the rows of one side: the matrix of the right rule is that
// of the left one with rows and columns in reverse order.
class SteppedSide final : public SideRule {
 public:
  // Precondition: the grid is uniform if the side is right.
  SteppedSide(const Problem& problem, Side side, const WeightFamily& family, const Grid& grid,
              const Options& options);

  void integrate(const Rows& f, Rows& value) const override;
  [[nodiscard]] std::unique_ptr<SideFactors> factors(const Matrix& jacobians) const override;
  [[nodiscard]] std::optional<ChosenHistory> history() const override {
    if (!history_prototype_) return {};
    return history_prototype_->chosen();
  }
  [[nodiscard]] std::size_t bytes() const override {
    return history_prototype_ ? history_prototype_->bytes() : 0;
  }

 private:
  class Factors;

  // The index in the grid of the m-th own time.
  [[nodiscard]] Eigen::Index grid_index(Eigen::Index m) const { return right_ ? steps_ - m : m; }
  // (mass - kappa J)^-1, J restricted to the rows of this side, one column an own time: two where steps and
  // Jacobians are all equal, the first for the start.
  [[nodiscard]] Matrix inverses(const Matrix& jacobians) const;
  template <typename Step>
  void for_each_own_time(Step step) const;

  [[nodiscard]] auto mass(Eigen::Index m) const { return mass_.col(m > 0 ? 1 : 0); }
  [[nodiscard]] auto kappa(Eigen::Index m) const { return kappa_.col(std::min(m, kappa_.cols() - 1)); }

  Grid grid_;
  Eigen::Index steps_;
  Matrix mass_;   // at the start, later
  Matrix kappa_;  // one column an own time, 0 at the start; on uniform grids two
  std::unique_ptr<History> history_prototype_{};  // copied for each pass over the own times
};

// The rules of a family of weights for both sides. Problem and family must outlive it.
std::shared_ptr<const Discretisation> discretisation_by_steps(const Problem& problem, const Grid& grid,
                                                              const Options& options,
                                                              const WeightFamily& family);

}  // namespace fde
