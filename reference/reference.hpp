#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fde {

// What is known about a solution at one time: one value a component, and a bound (or, where it says so, an
// estimate) of the absolute error of each.
struct ReferenceValue {
  Vec value;
  Vec bound;
};

// A value and a bound of its absolute error, both written out in decimal.
struct Decimal {
  std::string value;
  std::string bound;
};

// What a reference rests on. The first two state bounds; of two methods that share no line the difference
// is what is said.
enum class Evidence { closed_form, laplace_transform, two_methods };

// A known solution as a function of time, in double and to any number of decimal digits.
// Parameters and times are read as the shortest decimals that name them, so 0.1 means one tenth here.
struct Reference {
  std::function<ReferenceValue(double t)> at;
  std::function<std::vector<Decimal>(double t, int digits)> digits{};  // empty: double is all there is
  Evidence evidence = Evidence::closed_form;
};

}  // namespace fde
