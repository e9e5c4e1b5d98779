// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/characteristic_count.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

using Point = Rectangle::Point;

// Change of arg P on the straight path from a to b; nullopt unless |P| is shown to stay away from 0, where
// arg P changes by order Im(b - a) plus less than pi/4. For large |w|, where one term or terms of nearly the
// same order dominate, the path may have any length. The values at a and b do not suffice: next to two close
// zeros, arg P turns twice by nearly pi.
std::optional<long double> argument_change_on_segment(const CharacteristicFunction& function, const Point& a,
                                                      const Point& b) {
  const auto [at_a, order, change] = function.path_bound(a, b);
  if (!(change < 0.7L * std::abs(at_a))) return std::nullopt;
  const Point at_b = function.scaled_value(b).value;
  const long double turned = order * (b - a).imag();
  return turned + std::arg(at_b * std::conj(at_a) * std::polar(1.0L, -turned));
}

// Change of arg P from a to b, by bisection; nullopt where a zero is on the path up to rounding.
std::optional<long double> argument_change(const CharacteristicFunction& function, const Point& a,
                                           const Point& b) {
  constexpr long double shortest = 1e-11L;
  if (const auto there = argument_change_on_segment(function, a, b)) return there;
  if (const auto back = argument_change_on_segment(function, b, a)) return -*back;
  const Point middle = (a + b) / 2.0L;
  const auto [at_middle, noise, digits] = function.scaled_value(middle);
  if (std::abs(b - a) < shortest || middle == a || middle == b || std::abs(at_middle) < 2.0L * noise)
    return std::nullopt;
  const auto first = argument_change(function, a, middle);
  const auto second = first ? argument_change(function, middle, b) : std::nullopt;
  return second ? std::optional(*first + *second) : std::nullopt;
}

}  // namespace

std::optional<int> count_zeros(const CharacteristicFunction& function, const Rectangle& box) {
  const std::array<Point, 4> corners{Point(box.left, -box.height), Point(box.right, -box.height),
                                     Point(box.right, box.height), Point(box.left, box.height)};
  long double total = 0.0L;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const auto angle = argument_change(function, a, b);
    if (!angle) return std::nullopt;
    total += *angle;
  }
  return static_cast<int>(std::lround(total / (2.0L * pi_long)));
}

}  // namespace fde::reference
