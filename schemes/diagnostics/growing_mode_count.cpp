// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "fdebench/schemes/history/symbols/generating_function.hpp"
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
  if (has_algebraic_rows(problem)) reject("the problem has an algebraic row");
  if (const auto reason = unsupported_reason(scheme, problem, Grid{length, 1})) reject(*reason);
  return scheme.symbol(problem, length);
}

std::optional<int> count_growing_modes(const Scheme& scheme, const Problem& problem, double length) {
  const Symbol symbol = symbol_of(scheme, problem, length);
  const Contour contour(problem);
  const auto log_symbol = [&](double p) {
    const ComplexMatrix matrix = symbol(contour.at(p));
    if (!matrix.allFinite()) throw std::runtime_error("linear stability: the symbol is beyond double");
    return log_determinant(matrix);
  };
  // The argument of the product of the powers (1-zeta)^g_i changes by at most the sum of the orders per unit
  // of p.
  const double step = 0.25 / std::max(1.0, contour.total_order());
  const int pieces = static_cast<int>(std::ceil((contour.end() - Contour::begin) / step));
  // The lower half of the contour contributes the same change, because A is real.
  const double zeros = argument_change(log_symbol, Contour::begin, contour.end(), pieces) / std::numbers::pi;
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
