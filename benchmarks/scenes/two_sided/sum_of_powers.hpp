// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A sum of coefficient * t^power, t >= 0 and powers >= 0, the form of the manufactured solutions.
class SumOfPowers {
 public:
  struct Term {
    double coefficient, power;
  };

  SumOfPowers() = default;
  explicit SumOfPowers(std::vector<Term> terms);  // terms with equal powers are merged

  // From the coefficients of t^0, t^1, ...
  static SumOfPowers polynomial(const std::vector<double>& coefficients);

  [[nodiscard]] double at(double t) const;
  // A bound of the rounding error of at(t), with coefficients accurate to a few units in the last place.
  [[nodiscard]] double bound(double t) const;
  // The powers in increasing order, without 0.
  [[nodiscard]] std::vector<double> powers() const;

  // The Caputo derivative from 0 for order > 0, the fractional integral for order < 0: D^g t^p =
  // Gamma(p+1)/Gamma(p+1-g) t^(p-g), and 0 for an integer p < g.
  [[nodiscard]] SumOfPowers derivative(double order) const;
  // The same function as a sum of powers of s = end - t; requires integer powers.
  [[nodiscard]] SumOfPowers reversed(double end) const;

  friend SumOfPowers operator+(const SumOfPowers& a, const SumOfPowers& b);
  friend SumOfPowers operator*(const SumOfPowers& a, const SumOfPowers& b);
  friend SumOfPowers operator*(double factor, const SumOfPowers& a);

 private:
  std::vector<Term> terms_;
};

// A column of a manufactured solution: a sum of powers of t (left) or of end - t (right).
struct ManufacturedColumn {
  SumOfPowers sum;
  Side side = Side::left;
};

// The columns as a reference at times in [0, end]. It throws std::invalid_argument at other times.
reference::Reference manufactured_reference(const std::vector<ManufacturedColumn>& columns, double end);

}  // namespace fde::bench
