#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

// The powers t^p with which values on a uniform grid leave the value at 0, fitted to the first few of them:
// least squares, twice as many values as powers, so that what the values are off by is not blown up. Time is
// counted in steps.
class FittedPowers {
 public:
  static constexpr std::size_t most = 5;

  // Takes the smallest of these powers, each once, whole ones too: they are there to be told apart.
  explicit FittedPowers(std::vector<double> powers);

  [[nodiscard]] const std::vector<double>& powers() const { return powers_; }

  // One for each power, from the values at the steps from 0 on; at least 2 most + 1 of them.
  [[nodiscard]] Vec coefficients(const Vec& values) const;

 private:
  std::vector<double> powers_;
  Matrix inverse_{};  // (power, step - 1)
};

}  // namespace fde
