#include "transfer_functions/characteristic_count.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fde {
namespace {

using Point = Rectangle::Point;
using Polynomial = Characteristic<long double>;
constexpr long double pi_long = std::numbers::pi_v<long double>;

// Change of arg P on a long way from a to b. With the largest term c e^(o w) at a divided out, P changes by
// at most
//   sum over the others of |c_i e^(o_i a)| |e^((o_i - o)(b - a)) - 1|.
// Where that is less than 0.7 |P|, arg P turns by o Im(b - a) and less than pi/4 besides. Far out, where one
// term or terms of nearly one order are all there is, the way may be as long as it likes.
std::optional<long double> long_turn(const Polynomial& polynomial, const Point& a, const Point& b) {
  const auto sizes = polynomial.log_sizes(a);
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  const long double order = polynomial.terms[largest].order;
  long double change = 0.0L;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Point exponent = (polynomial.terms[i].order - order) * (b - a);
    const long double growth = exponent.real(), size = std::abs(exponent);
    const long double most = growth > 0.0L ? size * std::exp(growth) : std::min(size, 2.0L);
    change += std::exp(sizes[i] - sizes[largest]) * most;
  }
  const Point at_a = polynomial.direction(a), at_b = polynomial.direction(b);
  if (!(change < 0.7L * std::abs(at_a))) return std::nullopt;
  const long double turned = order * (b - a).imag();
  return turned + std::arg(at_b * std::conj(at_a) * std::polar(1.0L, -turned));
}

// Change of arg P from a to b in pieces; nothing where a zero is next to the way, as far as rounding tells.
std::optional<long double> turn(const Polynomial& polynomial, const Point& a, const Point& b) {
  constexpr long double shortest = 1e-11L, long_way = 0.1L;
  if (std::abs(b - a) < long_way) {
    const long double angle = std::arg(polynomial.direction(b) * std::conj(polynomial.direction(a)));
    if (std::abs(angle) < pi_long / 4.0L) return angle;
  } else if (const auto there = long_turn(polynomial, a, b)) {
    return there;
  } else if (const auto back = long_turn(polynomial, b, a)) {
    return -*back;
  }
  const Point middle = (a + b) / 2.0L;
  const long double noise =
      4.0L * epsilon<long double>() * (1.0L + polynomial.terms.back().order * std::abs(middle));
  if (std::abs(b - a) < shortest || middle == a || middle == b ||
      std::abs(polynomial.direction(middle)) < noise)
    return std::nullopt;
  const auto first = turn(polynomial, a, middle);
  const auto second = first ? turn(polynomial, middle, b) : std::nullopt;
  return second ? std::optional(*first + *second) : std::nullopt;
}

}  // namespace

std::optional<int> count_zeros(const Polynomial& polynomial, const Rectangle& box) {
  const std::array<Point, 4> corners{Point(box.left, -box.height), Point(box.right, -box.height),
                                     Point(box.right, box.height), Point(box.left, box.height)};
  long double total = 0.0L;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const auto angle = turn(polynomial, a, b);
    if (!angle) return std::nullopt;
    total += *angle;
  }
  return static_cast<int>(std::lround(total / (2.0L * pi_long)));
}

}  // namespace fde
