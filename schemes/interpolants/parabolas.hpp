#pragma once

#include "interpolants/interpolant.hpp"
#include "interpolants/slope_memory.hpp"
#include "weights/step_factors.hpp"

namespace fde {

// Parabolas through three values, one a step. On a step of length h the slope runs from (d - e)/h to
// (d + e)/h: d is the increment of y, and e the bend, h^2 times the second divided difference.

// Through y_(n-2), y_(n-1), y_n on step n, a line on the first; derivatives at t_n. L1-2.
class ParabolasFromBehind final : public Interpolant {
 public:
  ParabolasFromBehind(const Problem& problem, const Grid& grid, const Options& options);
  [[nodiscard]] Vec offsets() const override { return Vec::Ones(increment_.size()); }
  void derivative(int n, Out known, Out newest) override;
  void push(int n, In increment) override;
  [[nodiscard]] std::size_t bytes() const override { return lines_.bytes() + bends_.bytes(); }
  void state(Archive& archive) override { archive(lines_, bends_, increment_); }

 private:
  Grid grid_;
  SlopeMemory lines_, bends_;
  StepFactors factors_;  // h^g Gamma(2-g)
  Vec bent_line_;        // g / (2-g): what the bend of the newest step adds, where its line adds 1
  Vec increment_, bend_;
};

// Through y_(n-1), y_n, y_(n+1) on step n, a line on the newest; derivatives at the offset sigma = 1 - g/2 of
// each component, where that line is exact for t^2. L2-1-sigma.
class ParabolasFromAhead final : public Interpolant {
 public:
  ParabolasFromAhead(const Problem& problem, const Grid& grid, const Options& options);
  [[nodiscard]] Vec offsets() const override;
  void derivative(int n, Out known, Out newest) override;
  void push(int n, In increment) override;
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // The components of one order: where steps differ, they have a time t* of their own.
  struct Group {
    double order, offset;
    double line;  // offset^(1-g): how much of its slope the newest line adds at t*
    std::vector<Eigen::Index> rows;
    SlopeMemory lines, bends;
    StepFactors factors;  // h^g Gamma(2-g)
    double bend_factor;   // last_bend on equal steps
    Vec buffer;
  };
  // What the bend 1 of step n - 1 adds at t*.
  [[nodiscard]] double last_bend(const Group& group, int n) const;

  Grid grid_;
  std::vector<Group> groups_;
  Vec increment_, bend_;
};

}  // namespace fde
