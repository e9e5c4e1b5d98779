#pragma once

#include "exponential_sum.hpp"
#include "grid.hpp"
#include "history.hpp"
#include "running_sum.hpp"

namespace fde {

// Pasts on grids whose steps differ, where the sums of History are fractional integrals of piecewise linear
// functions (interval_weights.hpp), in units in which the newest sample has weight 1: on a uniform grid the
// same numbers.

// Every interval anew at every step: O(n) powers at step n.
class GradedDirectHistory final : public History {
 public:
  GradedDirectHistory(WeightTables tables, const Grid& grid);
  void push(In sample) override;
  void convolve(std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  [[nodiscard]] double convolved(const WeightTable& table, Eigen::Index component) const;

  WeightTables tables_;
  Grid grid_;
  Eigen::Index pushed_ = 0;
  Matrix samples_;  // (steps + 1) x components
};

// The kernel as decaying exponentials: each carries its own integral over the past from step to step. Orders
// above 1 integrate the running integral of the function with the order less 1.
class GradedExponentialHistory final : public History {
 public:
  // Needs steps that never shrink.
  GradedExponentialHistory(const WeightTables& tables, const Grid& grid, double tolerance);
  void push(In sample) override;
  void convolve(std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  // One component in one sum.
  struct Track {
    WeightTable table;
    std::size_t kernel;  // of kernels_
    Vec states{}, carries{};
    RunningSums integral{1};  // of the function, where the order is above 1
  };
  // The exponentials of one kernel exponent, and what the newest step does to those that still count at
  // distances from that step on: with x = nodes * length, the columns exp(-x) - 1, phi_1, phi_2, phi_3.
  struct Kernel {
    long double exponent;
    ExponentialSum sum{};
    Eigen::Index active = 0;
    Matrix step{};
  };
  // A polynomial on one interval, in powers of w = (t - start) / length: p0 + p1 w + p2 w^2 / 2.
  using Polynomial = Eigen::Vector3d;
  static Polynomial integrand(const Track& track, double before, double after, double length);
  void advance(Track& track, double before, double after, double length) const;
  void prepare(double length);

  Grid grid_;
  Eigen::Index pushed_ = 0;
  std::vector<Kernel> kernels_;
  std::vector<std::vector<Track>> tracks_;  // [sum][component]
  Vec newest_;
};

}  // namespace fde
