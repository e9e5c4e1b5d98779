#pragma once

#include "laplace/enclosing_contour.hpp"
#include "numbers/bounded.hpp"

namespace fde {

// Laplace transforms, inverted at time 1 on one enclosing contour: what invert() has to know of them.
struct EnclosedTransform {
  // Adds weight F(s), for each of the transforms, to their sums.
  using AddNode = std::function<void(const EnclosingContour::Node&, std::vector<Sum<BigReal>>&)>;

  std::vector<EnclosingContour::Point> singularities;
  EnclosingContour::Hints hints{};
  bool real = false;  // F(conj s) = conj F(s) and singularities in pairs: the upper half will do
  // Reads the numbers of the problem at the precision in force.
  std::function<AddNode()> prepare{};
  // One for each transform, or a single one for all.
  std::vector<EnclosingContour::Majorant> majorants{};
  // A value that many digits smaller than what it was put together from counts as zero.
  int zero_digits = 40;
};

// Raises the digits until every bound is 10^-wanted_digits of its value: discretisation by
// EnclosingContour::log_bound, rounding by Sum. What counts as zero is accurate to what it was put together
// from, as in raise_digits(). Throws std::runtime_error where the contour has too many nodes, e^s is beyond
// all exponents, or digits run out: at 4 times the wanted digits and 1000.
std::vector<Bounded<BigReal>> invert(const EnclosedTransform& transform, int wanted_digits);

}  // namespace fde
