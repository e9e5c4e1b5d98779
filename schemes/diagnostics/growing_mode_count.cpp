// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "fdebench/schemes/problem/scalar_equation.hpp"

namespace fde {
namespace {

// The upper half of the contour, parametrised by p: for p in [-1, 0] a quarter circle about zeta = 1 from the
// real axis, then the unit circle to -1, where p is the logarithm of the ratio of the angle to its first
// value.
class Contour {
 public:
  explicit Contour(const Problem& problem) {
    double smallest = 2.0;
    for (const auto& component : problem.components) {
      smallest = std::min(smallest, component.order);
      total_order_ += component.order;
    }
    radius_ = std::pow(10.0, -std::clamp(6.0 / smallest, 12.0, 300.0));
  }

  static constexpr double begin = -1.0;
  [[nodiscard]] double end() const { return std::log(std::numbers::pi / radius_); }

  // log zeta
  [[nodiscard]] ComplexValue at(double p) const {
    if (p < 0.0) return -std::polar(radius_, -0.5 * std::numbers::pi * (1.0 + p));
    return {0.0, std::min(radius_ * std::exp(p), std::numbers::pi)};
  }

  [[nodiscard]] double total_order() const { return total_order_; }

 private:
  double total_order_ = 0.0, radius_;
};

// log det, up to multiples of 2 pi i; the real part is -infinity where det is 0.
ComplexValue log_determinant(const ComplexMatrix& matrix) {
  if (!matrix.allFinite()) throw std::runtime_error("linear stability: the symbol is beyond double");
  const Eigen::PartialPivLU<ComplexMatrix> lu(matrix);
  const double sign = lu.permutationP().determinant() > 0 ? 0.0 : std::numbers::pi;
  ComplexValue sum{0.0, sign};
  for (const ComplexValue pivot : lu.matrixLU().diagonal()) sum += std::log(pivot);
  return sum;
}

// The change of the argument of det S along the contour, summed over pieces on which det S changes by less
// than half of its size; NaN where no such pieces are found, near a zero.
class ArgumentChange {
 public:
  ArgumentChange(const Symbol& symbol, const Contour& contour) : symbol_(symbol), contour_(contour) {}

  [[nodiscard]] double total() const {
    // The argument of the product of the powers (1-zeta)^g_i changes by at most the sum of the orders per
    // unit of p; the pieces are so short that they cannot miss a full turn of it.
    const double step = 0.25 / std::max(1.0, contour_.total_order());
    const double length = contour_.end() - Contour::begin;
    const int pieces = static_cast<int>(std::ceil(length / step));
    double turn = 0.0;
    Point last = at(Contour::begin);
    for (int i = 1; i <= pieces; ++i) {
      const Point next = at(Contour::begin + length * i / pieces);
      turn += between(last, next, 0);
      if (std::isnan(turn)) return turn;
      last = next;
    }
    return turn;
  }

 private:
  struct Point {
    double p;
    ComplexValue log_determinant;
  };

  [[nodiscard]] Point at(double p) const { return {p, log_determinant(symbol_(contour_.at(p)))}; }

  // det S at b divided by det S at a.
  static ComplexValue ratio(const Point& a, const Point& b) {
    return std::exp(b.log_determinant - a.log_determinant);
  }

  static bool close(const Point& a, const Point& b) {
    const ComplexValue r = ratio(a, b);
    return std::abs(r - 1.0) < 0.5 * std::min(1.0, std::abs(r));
  }

  // The midpoint detects a piece on which det S changes and returns.
  [[nodiscard]] double between(const Point& a, const Point& b, int depth) const {
    constexpr int deepest = 40;
    if (depth == deepest || std::isinf(a.log_determinant.real()) || std::isinf(b.log_determinant.real()))
      return NAN;
    const Point middle = at(0.5 * (a.p + b.p));
    if (close(a, b) && close(a, middle) && close(middle, b)) return std::arg(ratio(a, b));
    const double first = between(a, middle, depth + 1);
    return std::isnan(first) ? first : first + between(middle, b, depth + 1);
  }

  const Symbol& symbol_;
  const Contour& contour_;
};

}  // namespace

Problem test_problem(const Scheme& scheme, double order, ComplexValue rate, double end) {
  return scheme.capabilities.discretises_equations ? scalar_multi_term_equation(order, rate, end)
                                                   : scalar_equation(order, rate, end);
}

Symbol symbol_of(const Scheme& scheme, const Problem& problem, double length) {
  const auto reject = [&](std::string_view reason) {
    throw std::invalid_argument(fmt::format("linear stability of {}: {}", scheme.id, reason));
  };
  if (!scheme.symbol) reject("the scheme has no symbol");
  if (!is_linear(problem)) reject("the problem has no linear part");
  if (is_two_sided(problem)) reject("the problem is posed at both ends");
  if (std::ranges::any_of(problem.components, is_algebraic)) reject("the problem has an algebraic row");
  if (const auto reason = unsupported_reason(scheme, problem, Grid{length, 1})) reject(*reason);
  return scheme.symbol(problem, length);
}

std::optional<int> count_growing_modes(const Scheme& scheme, const Problem& problem, double length) {
  const Symbol symbol = symbol_of(scheme, problem, length);
  const Contour contour(problem);
  // The lower half of the contour contributes the same change, because A is real.
  const double zeros = ArgumentChange(symbol, contour).total() / std::numbers::pi;
  if (!std::isfinite(zeros)) return std::nullopt;
  return static_cast<int>(std::lround(zeros));
}

bool is_linearly_stable(const Scheme& scheme, const Problem& problem, double length) {
  return count_growing_modes(scheme, problem, length) == 0;
}

double largest_stable_step(const Scheme& scheme, const Problem& problem, double shortest, double longest) {
  constexpr double ratio = 1.05, digits = 1e-9;
  double low = 0.0, high = shortest;
  while (is_linearly_stable(scheme, problem, high)) {
    if (high == longest) return longest;
    low = high;
    high = std::min(longest, ratio * high);
  }
  while (low > 0.0 && high - low > digits * high) {
    const double middle = 0.5 * (low + high);
    (is_linearly_stable(scheme, problem, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace fde
