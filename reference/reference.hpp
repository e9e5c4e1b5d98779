// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// A reference solution at one time: one value per component, and a bound (or, where the function says so, an
// estimate) of the absolute error of each.
struct ReferenceValue {
  Vec value;
  Vec bound;
};

// A value and a bound of its absolute error, both as decimal text.
struct Decimal {
  std::string value;
  std::string bound;
};

// How a reference is obtained. closed_form and laplace_transform give error bounds; two_methods gives an
// error estimate from the difference of two methods with different discretisations; estimate is any other
// value, such as that of one run whose error is estimated from others.
enum class Evidence { estimate, two_methods, laplace_transform, closed_form };

// A zero s of the characteristic function P of a linear problem on the principal sheet |arg s| <= pi: its
// solutions contain a multiple of e^(s t), at a multiple zero times powers of t. s = 0 stands for P(0) = 0.
struct CharacteristicZero {
  std::complex<double> s;
  int multiplicity = 1;
};

// A reference solution as a function of time, in double and to any number of decimal digits.
// Parameters and times are taken as their shortest decimal representations: 0.1 is exactly one tenth.
struct Reference {
  std::function<ReferenceValue(double t)> at;
  std::function<std::vector<Decimal>(double t, int digits)> digits{};  // empty: available in double only
  Evidence evidence = Evidence::estimate;                              // what is proved says so
  std::optional<double> seconds{};  // processor time that it took to compute, for a reference by two methods
  // All zeros of the characteristic function, those to the right first; empty: not known. Without loads every
  // solution tends to 0 if and only if all zeros have negative real parts (Matignon 1996; Bonnet &
  // Partington, Automatica 38 (2002)). Throws std::runtime_error where the search does not find as many as it
  // counts.
  std::function<std::vector<CharacteristicZero>()> zeros{};
};

// The first of two references of the same quantities, with their difference and both bounds as its bound;
// empty where one is empty.
Reference with_difference(Reference one, Reference other);

}  // namespace fde::reference
