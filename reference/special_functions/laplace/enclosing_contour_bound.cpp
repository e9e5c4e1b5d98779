// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/enclosing_contour.hpp"
#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

using Long = long double;
using Point = EnclosingContour::Point;

Long log_of_sum(Long a, Long b) {
  const Long large = std::max(a, b), small = std::min(a, b);
  return std::isinf(large) || small == -infinity_long ? large : large + std::log1p(std::exp(small - large));
}

}  // namespace

// Logarithms of bounds of (1/2 pi) int |e^s F ds| over an edge of the rectangle, relative to e^sigma. The
// edge is split into pieces, each inside a disc.
class EnclosingContour::Boundary {
 public:
  Boundary(const EnclosingContour& contour, const Majorant& majorant)
      : contour_(contour), majorant_(majorant) {}

  // Horizontal: Im theta = y. The whole integral is divided by e^(2 pi |y| / h) - 1.
  [[nodiscard]] Long line(Long y, Long end) const {
    const Long steps = two_pi_long * std::abs(y) / contour_.step_;
    return edge(Point(-end, y), Point(end, y), false) - steps - std::log1p(-std::exp(-steps));
  }
  // Vertical: divided by 1 + e^(2 pi |Im theta| / h) point by point.
  [[nodiscard]] Long side(Long x) const {
    return log_of_sum(edge(Point(x, -contour_.below_), Point(x, 0.0L), true),
                      edge(Point(x, 0.0L), Point(x, contour_.above_), true));
  }

 private:
  static constexpr int deepest = 60, most_pieces = 10'000'000;

  [[nodiscard]] Long edge(const Point& a, const Point& b, bool with_factor) const {
    constexpr int pieces = 16;
    Long sum = -infinity_long;
    for (int k = 0; k < pieces; ++k) {
      const Point step = (b - a) / static_cast<Long>(pieces);
      sum = log_of_sum(
          sum, piece(a + static_cast<Long>(k) * step, a + static_cast<Long>(k + 1) * step, with_factor, 0));
    }
    return sum;
  }

  [[nodiscard]] Long piece(const Point& a, const Point& b, bool with_factor, int depth) const {
    // |s'| is 2 mu |1 + i theta|, convex: largest at an end
    const Long slope =
        2.0L * contour_.mu_ *
        std::max(std::abs(Point(1.0L - a.imag(), a.real())), std::abs(Point(1.0L - b.imag(), b.real())));
    const Long length = slope * std::abs(b - a);
    const Point middle = contour_.at((a + b) / 2.0L);
    const Long exponent = largest_exponent(a, b, with_factor);
    const bool steep = exponent - exponent_at((a + b) / 2.0L, with_factor) > 1.0L;
    // slightly more than half the length, for rounding
    const Long size = steep ? infinity_long : majorant_({middle, 0.5001L * length});
    if (size == -infinity_long) return size;
    const Long centre = steep ? 0.0L : majorant_({middle, 0.0L});
    if (size < infinity_long && (depth > deepest / 2 || size - centre < 1.0L))
      return exponent + size + std::log(length / two_pi_long);
    if (depth == deepest || !(centre < infinity_long)) {
      throw std::runtime_error(
          fmt::format("enclosing contour: no bound of the transform near s = {:.6g} {:+.6g} i", middle.real(),
                      middle.imag()));
    }
    if (++pieces_ > most_pieces)
      throw std::runtime_error("enclosing contour: the bound takes too many discs");
    const Point half = (a + b) / 2.0L;
    return log_of_sum(piece(a, half, with_factor, depth + 1), piece(half, b, with_factor, depth + 1));
  }

  [[nodiscard]] Long exponent_at(const Point& theta, bool with_factor) const {
    const Long factor = with_factor ? two_pi_long * std::abs(theta.imag()) / contour_.step_ : 0.0L;
    return contour_.at(theta).real() - contour_.sigma_ - factor;
  }
  // Re s decreases with |Re theta| and with Im theta < 1; the factor decreases with |Im theta|.
  [[nodiscard]] Long largest_exponent(const Point& a, const Point& b, bool with_factor) const {
    const Long x = a.real() * b.real() < 0.0L ? 0.0L : std::min(std::abs(a.real()), std::abs(b.real()));
    const Long nearest = std::min(std::abs(a.imag()), std::abs(b.imag()));
    const Long factor = with_factor ? two_pi_long * nearest / contour_.step_ : 0.0L;
    return exponent_at(Point(x, std::min(a.imag(), b.imag())), false) - factor;
  }

  const EnclosingContour& contour_;
  const Majorant& majorant_;
  mutable int pieces_ = 0;
};

long double EnclosingContour::log_bound(const Majorant& majorant) const {
  const Boundary boundary(*this, majorant);
  const Long end = (static_cast<Long>(count_) + 0.5L) * step_;
  Long sum = log_of_sum(boundary.line(above_, end), boundary.line(-below_, end));
  for (const Long x : {-end, end}) {
    const Point last = at(Point(x, 0.0L));
    sum = log_of_sum(sum, boundary.side(x));
    sum = log_of_sum(sum, std::log(4.0L) + last.real() - sigma_ + majorant({last, 0.0L}));
  }
  return sigma_ + sum;
}

}  // namespace fde::reference
