#include "growing_modes.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace fde {
namespace {

// The upper half of the contour as a function of one parameter: a quarter circle about zeta = 1 from the real
// axis, p in [-1, 0], then the unit circle to -1, p the logarithm of the angle above that of its start.
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

  // det M without its singularity at zeta = 1: times (1 - zeta)^(sum of the orders), which has no zero
  // inside.
  [[nodiscard]] ComplexValue determinant(const Symbol& symbol, double p) const {
    const ComplexValue log_zeta = at(p);
    const ComplexMatrix m = symbol(log_zeta);
    const ComplexValue det = m.rows() == 1 ? m(0, 0) : m.partialPivLu().determinant();
    return det / generating_function({WeightFamily::grunwald_letnikov, total_order_}, log_zeta);
  }

 private:
  double total_order_ = 0.0, radius_;
};

// How far the argument of a function turns along the path, in steps so short that each changes the function
// by less than half of it; not finite when there are none, next to a zero.
class Turn {
 public:
  Turn(const Symbol& symbol, const Contour& contour) : symbol_(symbol), contour_(contour) {}

  [[nodiscard]] double total() const {
    constexpr double step = 0.25;
    const double length = contour_.end() - Contour::begin;
    const int pieces = static_cast<int>(std::ceil(length / step));
    double turn = 0.0, p = Contour::begin;
    ComplexValue value = at(p);
    for (int i = 1; i <= pieces; ++i) {
      const double next = Contour::begin + length * i / pieces;
      const ComplexValue there = at(next);
      turn += between(p, value, next, there, 0);
      if (std::isnan(turn)) return turn;
      p = next;
      value = there;
    }
    return turn;
  }

 private:
  [[nodiscard]] ComplexValue at(double p) const { return contour_.determinant(symbol_, p); }

  [[nodiscard]] double between(double a, ComplexValue at_a, double b, ComplexValue at_b, int depth) const {
    constexpr int deepest = 40;
    if (depth == deepest || at_a == 0.0 || at_b == 0.0) return NAN;
    if (std::abs(at_b - at_a) < 0.5 * std::min(std::abs(at_a), std::abs(at_b))) return std::arg(at_b / at_a);
    const double middle = 0.5 * (a + b);
    const ComplexValue value = at(middle);
    const double first = between(a, at_a, middle, value, depth + 1);
    return std::isnan(first) ? first : first + between(middle, value, b, at_b, depth + 1);
  }

  const Symbol& symbol_;
  const Contour& contour_;
};

}  // namespace

Symbol symbol_of(const Scheme& scheme, const Problem& problem, double length) {
  const auto reject = [&](std::string_view reason) {
    throw std::invalid_argument(fmt::format("linear stability of {}: {}", scheme.id, reason));
  };
  if (!scheme.symbol) reject("the scheme has no symbol");
  if (!problem.linear_part) reject("the problem has no linear_part");
  if (two_sided(problem)) reject("the problem is posed at both ends");
  if (std::ranges::any_of(problem.components, algebraic)) reject("the problem has an algebraic row");
  if (const auto reason = refusal(scheme, problem, {length, 1})) reject(*reason);
  return scheme.symbol(problem, length);
}

std::optional<int> growing_modes(const Scheme& scheme, const Problem& problem, double length) {
  const Symbol symbol = symbol_of(scheme, problem, length);
  // The other half of the contour turns as far, A being real.
  const double zeros = Turn(symbol, Contour(problem)).total() / std::numbers::pi;
  if (!std::isfinite(zeros)) return std::nullopt;
  return static_cast<int>(std::lround(zeros));
}

bool stable(const Scheme& scheme, const Problem& problem, double length) {
  return growing_modes(scheme, problem, length) == 0;
}

double largest_stable_step(const Scheme& scheme, const Problem& problem, double shortest, double longest) {
  constexpr double ratio = 1.05, digits = 1e-9;
  double low = 0.0, high = shortest;
  while (stable(scheme, problem, high)) {
    if (high == longest) return longest;
    low = high;
    high = std::min(longest, ratio * high);
  }
  while (low > 0.0 && high - low > digits * high) {
    const double middle = 0.5 * (low + high);
    (stable(scheme, problem, middle) ? low : high) = middle;
  }
  return low;
}

Problem scalar_equation(double order, ComplexValue rate, double end) {
  const bool real = rate.imag() == 0.0;
  const double x = rate.real(), y = rate.imag();
  const Matrix matrix = real ? Matrix::Constant(1, 1, x) : (Matrix(2, 2) << x, -y, y, x).finished();
  std::vector<double> start(initial_count(order), 0.0);
  start.front() = 1.0;
  return {.components = std::vector<Component>(real ? 1 : 2, {order, start}),
          .rhs = [=](double, In u, Out f) { f = matrix * u; },
          .linear_part = matrix,
          .end = end};
}

}  // namespace fde
