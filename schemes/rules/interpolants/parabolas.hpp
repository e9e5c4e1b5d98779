// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/interpolants/interpolant.hpp"

namespace fde {

// Piecewise quadratic interpolants, one parabola through three values per step. On a step of length h the
// slope goes from (d - e)/h to (d + e)/h, where d is the increment of y and e, here called the bend, is h^2
// times the second divided difference.

// L1-2 (Gao, Sun & Zhang 2014): on step n the parabola through y_(n-2), y_(n-1), y_n, linear on the first
// step; derivatives at t_n.
class BackwardParabolas final : public Interpolant {
 public:
  BackwardParabolas(const Problem& problem, const Grid& grid, const Options& options);
  [[nodiscard]] Vec offsets() const override { return Vec::Ones(increment_.size()); }
  void derivative(int n, Out known, Out newest) override;
  void push(int n, In increment) override;
  [[nodiscard]] std::size_t bytes() const override { return lines_.bytes() + second_differences_.bytes(); }
  [[nodiscard]] ChosenHistory history() const override { return lines_.history(); }
  void state(Archive& archive) override { archive(lines_, second_differences_, increment_); }

 private:
  Grid grid_;
  SlopeHistory lines_, second_differences_;
  StepFactors factors_;          // h^g Gamma(2-g)
  Vec second_difference_ratio_;  // g / (2-g): weight of the bend of the newest step, if its increment has
                                 // weight 1
  Vec increment_, bend_;
};

// L2-1_sigma (Alikhanov 2015): on step n the parabola through y_(n-1), y_n, y_(n+1), linear on the newest
// step; derivatives at the offset sigma = 1 - g/2 of each component, where the linear part is exact for t^2.
class ForwardParabolas final : public Interpolant {
 public:
  ForwardParabolas(const Problem& problem, const Grid& grid, const Options& options);
  [[nodiscard]] Vec offsets() const override;
  void derivative(int n, Out known, Out newest) override;
  void push(int n, In increment) override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] ChosenHistory history() const override { return groups_.front().lines.history(); }
  void state(Archive& archive) override;

 private:
  // The components of one order, which have the same time t*.
  struct Group {
    double order, offset;
    double line;  // offset^(1-g): h^g Gamma(2-g) times the weight of the newest increment at t*
    std::vector<Eigen::Index> rows;
    SlopeHistory lines, bends;
    StepFactors factors;  // h^g Gamma(2-g)
    double bend_factor;   // last_second_difference_weight, for equal steps
    Vec buffer;
  };
  // The weight of the bend of step n - 1 in the derivative at t*.
  [[nodiscard]] double last_second_difference_weight(const Group& group, int n) const;

  Grid grid_;
  std::vector<Group> groups_;
  Vec increment_, bend_;
};

}  // namespace fde
