#pragma once

#include "history/history.hpp"

namespace fde {

// The past on a grid whose steps differ: fractional integrals of piecewise linear functions
// (interval_weights.hpp), in units in which the newest sample has weight 1; on a uniform grid the sums of
// DirectHistory. Every interval is weighed anew at every step, O(n) powers at step n.
class GradedDirectHistory final : public History {
 public:
  GradedDirectHistory(const WeightTables& tables, const Grid& grid);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<GradedDirectHistory>(*this);
  }
  void push(In sample) override;
  void convolve(std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  // The weights of all intervals at the newest step, for one order of integration.
  struct Integral {
    double order;
    Vec left, right;
  };
  // One component in one sum.
  struct Track {
    Eigen::Index component;
    WeightTable table;
    std::size_t integral;
  };

  Grid grid_;
  int pushed_ = 0;
  Matrix samples_;  // (steps + 1) x components
  std::vector<Integral> integrals_;
  std::vector<std::vector<Track>> tracks_;  // of each sum; without those that have no past
};

}  // namespace fde
