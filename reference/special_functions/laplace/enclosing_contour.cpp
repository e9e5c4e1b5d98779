// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/enclosing_contour.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/constants.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

using Long = long double;
using Point = EnclosingContour::Point;

Long log_of_sum(Long a, Long b) {
  const Long large = std::max(a, b), small = std::min(a, b);
  return std::isinf(large) || small == -infinity_long ? large : large + std::log1p(std::exp(small - large));
}

Long width_of(int digits) { return std::numbers::ln10_v<Long> * static_cast<Long>(digits) + 6.0L; }

}  // namespace

// A parabola for one choice of right_extent and c, and its number of nodes.
struct EnclosingContour::Shape {
  Long rise = 0.0L, c = 0.0L, step = 0.0L, above = 0.0L, below = 0.0L;
  Long nodes = infinity_long;
};

EnclosingContour::EnclosingContour(const std::vector<Point>& singularities, int digits, const Hints& hints) {
  if (singularities.empty()) throw std::invalid_argument("enclosing contour: there are no singularities");
  sigma_ = -infinity_long;
  for (const auto& s : singularities) sigma_ = std::max(sigma_, s.real());
  const Long width = width_of(digits);
  std::vector<Point> enclosed, others;
  for (const auto& s : singularities)
    (is_relevant(s, sigma_, digits, hints) ? enclosed : others).push_back(s);
  for (bool complete = false; !complete;) {
    choose(enclosed, width, hints.order);
    const auto reached = std::partition(others.begin(), others.end(),
                                        [this](const Point& s) { return !is_near_rectangle(s); });
    complete = reached == others.end();
    enclosed.insert(enclosed.end(), reached, others.end());
    others.erase(reached, others.end());
  }
  const Long largest = std::abs(sigma_) + std::abs(y_) + width + mu_;
  working_digits_ = static_cast<int>(std::ceil(
                        (width + right_extent() + std::log(Long(count_) + 1.0L) + std::log1p(largest)) /
                        std::numbers::ln10_v<Long>)) +
                    4;
}

// The rectangle extends to the nearest image of a singularity, less a margin that keeps |s - s*|^-order small
// on its edge.
EnclosingContour::Shape EnclosingContour::shape(const std::vector<Point>& enclosed, Long width, Long margin,
                                                Long right_extent, Long c) const {
  const Long mu = right_extent + c;
  Long distance = 1.0L;
  for (const auto& s : enclosed) {
    const Point root = std::sqrt(Point(s.real() - sigma_ + c, s.imag() - y_) / mu);
    distance = std::min(distance, 1.0L - root.real());
  }
  if (distance <= 0.0L) return {};
  Shape found{.rise = right_extent, .c = c, .above = distance * (1.0L - margin)};
  // on Im theta = -a the error is e^(mu (1 + a)^2 - c - 2 pi a / h), least at 1 + a = pi / (h mu)
  const Long half_turns = mu + std::sqrt(mu * (right_extent + width));
  const Long top = std::max(0.0L, mu * (1.0L - found.above) * (1.0L - found.above) - c);
  found.step = std::min(two_pi_long * found.above / (width + top), pi_long / half_turns);
  // the nearest line where this is below e^-width: a farther one takes more discs in log_bound()
  const Long slack = pi_long / found.step - mu;
  found.below = (slack - std::sqrt(std::max(0.0L, slack * slack - mu * (right_extent + width + 3.0L)))) / mu;
  found.nodes = std::sqrt((right_extent + width) / mu) / found.step;
  return found;
}

void EnclosingContour::choose(const std::vector<Point>& enclosed, Long width, Long order) {
  Long low = infinity_long, high = -infinity_long;
  for (const auto& s : enclosed) {
    low = std::min(low, s.imag());
    high = std::max(high, s.imag());
  }
  constexpr Long in_pairs = 1e-9L;  // up to rounding
  y_ = std::abs(low + high) <= in_pairs * (high - low) ? 0.0L : (low + high) / 2.0L;
  const Long margin = std::min(0.3L, std::max(order, 2.0L) / width), half_height = (high - low) / 2.0L;
  Shape best;
  Long least = infinity_long;
  for (const Long part : {0.04L, 0.06L, 0.09L, 0.13L, 0.18L, 0.25L}) {
    const Long rise = part * width, cost_of_digits = 1.0L + 1.5L * part;
    const Long largest_c = 4.0L * (rise + half_height * half_height / rise);
    for (Long c = 0.0L; c <= largest_c; c = c == 0.0L ? 0.02L * rise : 1.12L * c) {
      const Shape now = shape(enclosed, width, margin, rise, c);
      if (now.nodes * cost_of_digits >= least) continue;
      best = now;
      least = now.nodes * cost_of_digits;
    }
  }
  if (!(best.nodes <= max_nodes)) {
    throw std::runtime_error(
        fmt::format("enclosing contour: singularities {:.3g} apart in imaginary direction would take {:.3g} "
                    "nodes, more than {}",
                    high - low, best.nodes, max_nodes));
  }
  c_ = best.c;
  mu_ = best.rise + best.c;
  step_ = best.step;
  above_ = best.above;
  below_ = best.below;
  count_ = static_cast<int>(std::ceil(best.nodes));
}

long double EnclosingContour::half_width() const {
  return 2.0L * mu_ * (1.0L + below_) * (static_cast<Long>(count_) + 0.5L) * step_;
}

// For large |s| the error of Re s is the rounding error of |s|.
bool EnclosingContour::is_relevant(const Point& singularity, long double sigma, int digits,
                                   const Hints& hints) {
  const Long size = std::abs(singularity),
             least = sigma - width_of(digits) - 2.0L - hints.growth * std::log1p(size);
  return singularity.real() + 8.0L * epsilon<Long>() * size >= least;
}

bool EnclosingContour::is_near_rectangle(const Point& singularity) const {
  const Point root = std::sqrt(Point(singularity.real() - sigma_ + c_, singularity.imag() - y_) / mu_);
  return std::abs(root.imag()) <= (static_cast<Long>(count_) + 2.0L) * step_;
}

Point EnclosingContour::at(const Point& theta) const {
  const Point root(1.0L - theta.imag(), theta.real());
  return Point(sigma_ - c_, y_) + mu_ * root * root;
}

std::vector<EnclosingContour::Node> EnclosingContour::nodes_from(int first) const {
  const BigReal mu(mu_), step(step_), left = BigReal(sigma_) - BigReal(c_), y(y_),
                                      scale = step * mu / pi<BigReal>();
  const int total = count_ - first + 1;
  std::vector<Node> nodes;
  for (int k = first; k <= count_; ++k) {
    report_progress(nodes.size(), static_cast<std::size_t>(total));
    const BigReal theta = k * step;
    const BigComplex root(BigReal(1), theta);
    const BigComplex s(BigReal(left + mu * (1 - theta * theta)), BigReal(y + 2 * mu * theta));
    // node 0 is its own conjugate: half its weight in the sum over the upper half
    const BigReal share = first == 0 && k == 0 ? BigReal(scale / 2) : scale;
    nodes.push_back({s, log(s), share * root * exp(s)});
  }
  return nodes;
}

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
