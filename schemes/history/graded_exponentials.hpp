#pragma once

#include <array>

#include "history/history.hpp"
#include "history/running_sum.hpp"
#include "weights/exponential_sum.hpp"

namespace fde {

// The sums of GradedDirectHistory with the kernel as decaying exponentials: each carries its own integral of
// the function from step to step, O(1) work a step. Orders above 1 integrate the running integral of the
// function with the order less 1. Needs steps that do not shrink, up to rounding. docs/the_past.md derives
// it.
class GradedExponentialHistory final : public History {
 public:
  GradedExponentialHistory(const WeightTables& tables, const Grid& grid, double tolerance);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<GradedExponentialHistory>(*this);
  }
  void push(In sample) override;
  void convolve(std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  // A polynomial on one interval, in w = (t - start) / length: p0 + p1 w + p2 w^2 / 2.
  using Polynomial = Eigen::Vector3d;

  // One component in one sum.
  struct Track {
    Eigen::Index component;
    WeightTable table;
    std::size_t kernel;
    Eigen::Index column;      // in its kernel
    RunningSums integral{1};  // of the function, where the order is above 1
    double to_sums = 0.0;     // integrals_to_sums of the newest step
  };

  // The exponentials of one kernel exponent, and what the newest step does to them, x = nodes * length.
  struct Kernel {
    long double exponent;
    double fastest = 0.0;  // node * distance up to which the sum needs its nodes
    Vec nodes{}, coefficients{};
    Eigen::Index active = 0;       // nodes that count at distances from the newest step on
    Vec decay_minus_one{};         // exp(-x) - 1
    Matrix phi{};                  // phi_1, phi_2, phi_3 of x
    Vec weights{};                 // coefficients * exp(-x)
    std::array<double, 3> near{};  // length^a / Gamma(a + k), k = 1, 2, 3: integrals of w^(k-1) / (k-1)!
    Matrix polynomials{};          // 3 x tracks
    Matrix states{}, carries{}, input{};  // nodes x tracks
  };

  std::size_t kernel_of(const WeightTable& table, double tolerance);
  static Polynomial integrand(const Track& track, double before, double after, double length);
  void advance(double length, In sample);
  void prepare(double length);

  Grid grid_;
  int pushed_ = 0;
  std::vector<Kernel> kernels_;
  std::vector<std::vector<Track>> tracks_;  // of each sum; without those that have no past
  Vec newest_;
};

}  // namespace fde
