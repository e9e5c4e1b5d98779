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
  const Long width = std::numbers::ln10_v<Long> * static_cast<Long>(digits) + 6.0L;
  // For large |s| the error of Re s is the rounding error of |s|.
  const auto matters = [&](const Point& s) {
    const Long size = std::abs(s), least = sigma_ - width - 2.0L - hints.growth * std::log1p(size);
    return s.real() + 8.0L * epsilon<Long>() * size >= least;
  };
  std::vector<Point> enclosed, others;
  for (const auto& s : singularities) (matters(s) ? enclosed : others).push_back(s);
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

// Whether an omitted singularity is inside the rectangle or near it.
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

}  // namespace fde::reference
