// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The unknown initial values of a problem, in the order of its components: value k of component i adds
// value t^k / k! to y_i, t the time of that row; in an algebraic row it counts at t = 0 only.
class UnknownInitialValues {
 public:
  explicit UnknownInitialValues(const Problem& problem);

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(unknowns_.size()); }

  // Adds to y the terms of these values at a time that is `left` from the start and `right` from the end.
  void add(In values, double left, double right, Out y) const;

 private:
  struct Unknown {
    Eigen::Index component;
    Side side;
    std::size_t power;
    bool algebraic;
  };
  std::vector<Unknown> unknowns_;
};

}  // namespace fde
