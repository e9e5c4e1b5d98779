#pragma once

#include <vector>

#include "scenes/scene.hpp"

namespace fde {

// A sum of coefficient * t^power, t >= 0 and powers of any size >= 0: what made solutions consist of.
class SumOfPowers {
 public:
  struct Term {
    double coefficient, power;
  };

  SumOfPowers() = default;
  explicit SumOfPowers(std::vector<Term> terms);  // terms of equal power become one

  // Coefficients of t^0, t^1, ...
  static SumOfPowers polynomial(const std::vector<double>& coefficients);

  [[nodiscard]] double at(double t) const;
  // Of the rounding of at(t): coefficients may be off by a few units in the last place.
  [[nodiscard]] double bound(double t) const;
  // In increasing order, without 0: how the sum starts.
  [[nodiscard]] std::vector<double> powers() const;

  // Caputo derivative from 0 for order > 0, fractional integral for order < 0:
  // D^g t^p = Gamma(p+1)/Gamma(p+1-g) t^(p-g), and 0 where p < g is a whole number.
  [[nodiscard]] SumOfPowers derivative(double order) const;
  // The same sum of s = end - t, for whole powers.
  [[nodiscard]] SumOfPowers reversed(double end) const;

  friend SumOfPowers operator+(const SumOfPowers& a, const SumOfPowers& b);
  friend SumOfPowers operator*(const SumOfPowers& a, const SumOfPowers& b);
  friend SumOfPowers operator*(double factor, const SumOfPowers& a);

 private:
  std::vector<Term> terms_;
};

// A column of a made solution: a sum of powers of t, or of the time that is left.
struct MadeColumn {
  SumOfPowers sum;
  Side side = Side::left;
};

// The columns at times in [0, end]. Throws std::invalid_argument for others.
Reference made_solution(const std::vector<MadeColumn>& columns, double end);

}  // namespace fde
