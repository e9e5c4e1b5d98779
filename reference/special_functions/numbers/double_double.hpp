// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// An unevaluated sum hi + lo with |lo| at most half a unit in the last place of hi: about 32 digits.
struct DoubleDouble {
  double hi, lo;
};

// x rounded to a double-double. Precondition: a Precision of at least 40 digits is in force.
DoubleDouble to_double_double(const BigReal& x);

// a + b and a b without error.
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b, added = sum - a;
  return {sum, (a - (sum - added)) + (b - added)};
}
inline DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}
// Rounded to a double-double.
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_sum(a.hi, b.hi), low = exact_sum(a.lo, b.lo);
  const DoubleDouble sum = exact_sum(high.hi, high.lo + low.hi);
  return exact_sum(sum.hi, sum.lo + low.lo);
}

// Largest number of double-doubles in a vector.
inline constexpr std::size_t double_double_lanes = 8;

inline constexpr DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
inline constexpr DoubleDouble pi_double_double{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// Series of e^r for |r| <= ln 2 / 128, and of sin r / r and cos r in r^2 for |r| <= pi / 256: the first
// coefficients in double-double, the others in double.
inline constexpr std::array<DoubleDouble, 6> exponential_head{
    {{1.0, 0.0},
     {1.0, 0.0},
     {0.5, 0.0},
     {0x1.5555555555555p-3, 0x1.5555555555555p-57},
     {0x1.5555555555555p-5, 0x1.5555555555555p-59},
     {0x1.1111111111111p-7, 0x1.1111111111111p-63}}};
inline constexpr std::array<double, 6> exponential_tail{1.0 / 720.0,    1.0 / 5040.0,    1.0 / 40320.0,
                                                        1.0 / 362880.0, 1.0 / 3628800.0, 1.0 / 39916800.0};
inline constexpr std::array<DoubleDouble, 3> sine_head{{{1.0, 0.0},
                                                        {-0x1.5555555555555p-3, -0x1.5555555555555p-57},
                                                        {0x1.1111111111111p-7, 0x1.1111111111111p-63}}};
inline constexpr std::array<double, 4> sine_tail{-1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0,
                                                 1.0 / 6227020800.0};
inline constexpr std::array<DoubleDouble, 4> cosine_head{{{1.0, 0.0},
                                                          {-0.5, 0.0},
                                                          {0x1.5555555555555p-5, 0x1.5555555555555p-59},
                                                          {-0x1.6c16c16c16c17p-10, 0x1.f49f49f49f49fp-65}}};
inline constexpr std::array<double, 3> cosine_tail{1.0 / 40320.0, -1.0 / 3628800.0, 1.0 / 479001600.0};

// Tables of 2^(j/64) and of cosine and sine of 2 pi j / 256, and their steps; computed once, by MPFR.
struct ElementaryTables {
  static constexpr int exponential_steps = 64, angles = 256;

  DoubleDouble exponential_step, angle_step;  // ln 2 / 64, 2 pi / 256
  double angle_step_rest;                     // 2 pi / 256 - angle_step
  std::array<double, exponential_steps> exponentials_hi, exponentials_lo;
  std::array<double, angles> cosines_hi, cosines_lo, sines_hi, sines_lo;

  static const ElementaryTables& get();
};

}  // namespace fde::reference
