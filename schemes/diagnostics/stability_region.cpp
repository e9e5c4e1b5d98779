// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/stability_region.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

#include "fdebench/schemes/history/symbols/generating_function.hpp"

namespace fde {

namespace {

constexpr double pi = std::numbers::pi;

// The determinant 1 + linear z + square z^2 of the symbol, before its columns are scaled, at one zeta. z
// occurs in one entry of A, so each factor A raises the degree by one.
struct Characteristic {
  ComplexValue linear, square;
};

class ScalarSymbol {
 public:
  ScalarSymbol(const Scheme& scheme, double order, int delay = 0)
      : linear_(scheme.capabilities.implicit || delay > 0),
        size_(scheme.capabilities.implicit ? large : 1.0),
        plus_(symbol_of(scheme, test_problem(scheme, order, size_, 1.0, delay), 1.0)),
        minus_(symbol_of(scheme, test_problem(scheme, order, -size_, 1.0, delay), 1.0)),
        order_(order) {}

  [[nodiscard]] Characteristic at(double theta) const { return at(ComplexValue{0.0, theta}); }
  [[nodiscard]] Characteristic at(ComplexValue log_zeta) const {
    const ComplexValue power = difference_power(order_, log_zeta);
    const ComplexValue plus = plus_(log_zeta).determinant() / power,
                       minus = minus_(log_zeta).determinant() / power;
    return {0.5 * (plus - minus) / size_, linear_ ? 0.0 : 0.5 * (plus + minus) - 1.0};
  }

 private:
  // Implicit rules need the linear coefficient only; with such a large z the 1 is negligible, also where the
  // boundary is far from 0. A chain of links would lose it by rounding.
  static constexpr double large = 0x1p80;

  bool linear_;  // in z: a prediction is multiplied by z once more, an earlier value is not predicted
  double size_;
  Symbol plus_, minus_;
  double order_;
};

std::vector<ComplexValue> roots(const Characteristic& p) {
  if (p.square == 0.0) return {-1.0 / p.linear};
  // The reciprocals 1/z = (-linear +- root)/2; the smaller one follows from their product, without
  // cancellation.
  ComplexValue root = std::sqrt(p.linear * p.linear - 4.0 * p.square);
  if ((std::conj(p.linear) * root).real() < 0.0) root = -root;
  const ComplexValue larger = -0.5 * (p.linear + root);
  return {1.0 / larger, larger / p.square};
}

// A function with a zero where a root crosses the real axis: the imaginary part of the determinant gives the
// real root x; this is the real part at x times a power of its denominator.
double crossing(const Characteristic& p) {
  const double a1 = p.linear.real(), a2 = p.square.real(), b1 = p.linear.imag(), b2 = p.square.imag();
  if (p.square == 0.0) return b1;
  return b2 * b2 - a1 * b1 * b2 + a2 * b1 * b1;
}

// The real root at a zero of `crossing`, as x = -z.
double crossed_at(const Characteristic& p) {
  return p.square == 0.0 ? 1.0 / p.linear.real() : p.linear.imag() / p.square.imag();
}

// Increasing angles between 0 and pi, with a ratio of 1.02 near 0 and near pi, where the crossings of orders
// close to an integer are. Closer to the ends the imaginary part of the determinant is below rounding.
struct Angles {
  static constexpr double lowest = -20.0, step = 0.02;  // of the logarithm
  int half = static_cast<int>(std::ceil((std::log(pi / 2) - lowest) / step));
  [[nodiscard]] int count() const { return 2 * half + 1; }
  [[nodiscard]] double at(int i) const { return i <= half ? from_end(i) : pi - from_end(2 * half - i); }

 private:
  [[nodiscard]] double from_end(int i) const {
    return std::exp(lowest + (std::log(pi / 2) - lowest) * i / half);
  }
};

// The roots at a real zeta that are on the negative real axis, as x = -z.
std::vector<double> negative_roots(const Characteristic& p) {
  std::vector<double> found;
  for (const ComplexValue z : roots(p)) {
    if (std::abs(z.imag()) < 1e-9 * std::abs(z) && z.real() < 0.0) found.push_back(-z.real());
  }
  return found;
}

struct Sample {
  double theta;
  Characteristic value;
};

// The x > 0 at which the boundary crosses the real axis at -x between two angles; nullopt: nowhere.
std::optional<double> crossing_between(const ScalarSymbol& symbol, Sample low, const Sample& high) {
  const bool sign_at_low = std::signbit(crossing(low.value));
  if (sign_at_low == std::signbit(crossing(high.value))) return std::nullopt;
  for (double last = high.theta; last - low.theta > 1e-15 * last;) {
    const double middle = 0.5 * (low.theta + last);
    if (middle == low.theta || middle == last) break;
    const Characteristic value = symbol.at(middle);
    if (std::signbit(crossing(value)) == sign_at_low) {
      low = {middle, value};
    } else {
      last = middle;
    }
  }
  const double x = crossed_at(low.value);
  return x > 0.0 ? std::optional(x) : std::nullopt;
}

// The x > 0, increasing, at which the boundary may cross the real axis at -x: at zeta = -1; at zeta = 1, for
// a predictor-corrector where det(I + k A) = 0; and in between. A delay makes it cross many times, of which
// the nearest matter: where |z| is larger than at a known crossing, no more are searched for.
std::vector<double> crossings(const ScalarSymbol& symbol, int delay) {
  const Angles angles;
  constexpr double to_one = -1e-13;  // log zeta; 1 itself is a pole
  std::vector<double> found = negative_roots(symbol.at(pi));
  std::ranges::copy(negative_roots(symbol.at(ComplexValue(to_one))), std::back_inserter(found));
  const auto at = [&](double theta) { return Sample{theta, symbol.at(theta)}; };
  Sample last = at(angles.at(0));
  for (int i = 1; i < angles.count(); ++i) {
    const Sample next = at(angles.at(i)), first = last;
    last = next;
    const double turned = delay * (next.theta - first.theta);
    const double least = 1.0 / std::max(std::abs(first.value.linear), std::abs(next.value.linear));
    if (delay > 0 && std::ranges::any_of(found, [&](double x) { return x < least; })) continue;
    const int parts = 1 + static_cast<int>(4.0 * turned);
    Sample low = first;
    for (int part = 1; part <= parts; ++part) {
      const Sample high = part == parts ? next : at(first.theta + (next.theta - first.theta) * part / parts);
      if (const auto x = crossing_between(symbol, low, high)) found.push_back(*x);
      low = high;
    }
  }
  std::ranges::sort(found);
  return found;
}

bool stable_at(const Scheme& scheme, double order, double x, int delay) {
  return is_linearly_stable(scheme, test_problem(scheme, order, -x, 1.0, delay), 1.0);
}

constexpr int halvings = 8;  // of the interval in which a piece ends

// The angle theta for f in [0, 1], from 1e-6 to pi, with points denser at both ends.
double angle_at(double f) { return std::numbers::pi * f * f * f * (4.0 - 3.0 * f) + 1e-6 * (1.0 - f); }

// One root locus curve, from the root `last` at zeta = -1 to zeta = 1.
class BoundaryCurve {
 public:
  BoundaryCurve(const Scheme& scheme, double order, int points, ComplexValue last)
      : scheme_(scheme), order_(order) {
    ComplexValue z = last;
    for (int i = points; i >= 0; --i) {
      const double theta = angle_at(static_cast<double>(i) / points);
      z = nearest_root(root_locus(scheme, order, theta), z);
      curve_.push_back({theta, z});
    }
  }

  void add_pieces(std::vector<std::vector<BoundaryPoint>>& pieces) const {
    bool inside = false;
    for (std::size_t i = 0; i < curve_.size(); ++i) {
      const bool divided = divides(curve_[i]);
      if (divided && !inside) pieces.emplace_back();
      if (divided != inside && i > 0) {
        const auto end =
            divided ? end_of_piece(curve_[i], curve_[i - 1]) : end_of_piece(curve_[i - 1], curve_[i]);
        pieces.back().push_back(end);
      }
      if (divided) pieces.back().push_back(curve_[i]);
      inside = divided;
    }
  }

 private:
  // Whether stability changes across the curve at this point. For an implicit rule the whole curve is
  // boundary.
  [[nodiscard]] bool divides(const BoundaryPoint& at) const {
    if (scheme_.capabilities.implicit) return true;
    const ComplexValue out = boundary_normal(scheme_, order_, at.theta, at.z, 1e-3);
    return is_stable(at.z + out) != is_stable(at.z - out);
  }
  [[nodiscard]] bool is_stable(ComplexValue z) const {
    return is_linearly_stable(scheme_, test_problem(scheme_, order_, z), 1.0);
  }

  // The end of a piece by bisection, between a point of the piece and a point that is not on it.
  [[nodiscard]] BoundaryPoint end_of_piece(BoundaryPoint of_it, const BoundaryPoint& beyond) const {
    double outside = beyond.theta;
    for (int halving = 0; halving < halvings; ++halving) {
      const double theta = 0.5 * (of_it.theta + outside);
      const BoundaryPoint middle{theta, nearest_root(root_locus(scheme_, order_, theta), of_it.z)};
      if (divides(middle)) {
        of_it = middle;
      } else {
        outside = theta;
      }
    }
    return of_it;
  }

  const Scheme& scheme_;
  double order_;
  std::vector<BoundaryPoint> curve_{};
};

}  // namespace

std::vector<ComplexValue> root_locus(const Scheme& scheme, double order, double theta, int delay) {
  return roots(ScalarSymbol(scheme, order, delay).at(theta));
}

double real_stability_interval(const Scheme& scheme, double order, int delay) {
  auto ends = crossings(ScalarSymbol(scheme, order, delay), delay);
  // Between two crossings the number of growing modes does not change.
  ends.push_back(std::numeric_limits<double>::infinity());
  if (!stable_at(scheme, order, 0.5 * std::min(1.0, ends.front()), delay)) return 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double next = std::isinf(ends[i + 1]) ? 1.25 * ends[i] : std::sqrt(ends[i] * ends[i + 1]);
    if (!stable_at(scheme, order, next, delay)) return ends[i];
  }
  return ends.back();
}

double real_stability_interval(double order, double delay) {
  return std::pow(pi * (1.0 - 0.5 * order) / delay, order);
}

double stability_angle(const Scheme& scheme, double order) {
  if (std::isfinite(real_stability_interval(scheme, order))) return 0.0;
  const ScalarSymbol symbol(scheme, order);
  double angle = pi - 0.5 * order * pi;  // the limit of the boundary for theta -> 0
  const Angles angles;
  for (int i = 0; i <= angles.count(); ++i) {
    const double theta = i < angles.count() ? angles.at(i) : pi;
    for (const ComplexValue z : roots(symbol.at(theta))) angle = std::min(angle, std::abs(std::arg(-z)));
  }
  return angle;
}

std::optional<Vec> stiff_limit(const Scheme& scheme, double order, int steps) {
  // A rate so large that 1 is negligible: the result is the limit, to rounding.
  constexpr double infinite = -1e100;
  const Problem problem = test_problem(scheme, order, infinite, steps);
  symbol_of(scheme, problem, 1.0);
  if (!scheme.capabilities.implicit) return std::nullopt;
  const Rows y = scheme.solve(problem, Grid{problem.end, steps}, {}).y;
  Vec response = Vec::Constant(steps + 1, std::numeric_limits<double>::infinity());
  // Values of the size of 1/z are 0 in the limit.
  response.head(y.cols()) =
      y.row(0).transpose().unaryExpr([](double r) { return std::abs(r) < 1e-50 ? 0.0 : r; });
  return response;
}

std::vector<std::vector<BoundaryPoint>> region_boundary(const Scheme& scheme, double order, int points) {
  std::vector<std::vector<BoundaryPoint>> pieces;
  for (const ComplexValue last : root_locus(scheme, order, std::numbers::pi))
    BoundaryCurve(scheme, order, points, last).add_pieces(pieces);
  return pieces;
}

}  // namespace fde
