// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "fdebench/schemes/history/symbols/delayed_part.hpp"
#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"

namespace fde {
namespace {

// The upper half of a contour around the modes, in log zeta, parametrised by p: for p in [-1, 0] a quarter
// circle about 0 from the negative axis, then a ray on which p is the logarithm of the distance from 0, in
// units of the first one. For a scheme the ray is the unit circle up to zeta = -1. For an equation, where
// log zeta = -s length, it is beside the imaginary axis, and a quarter circle leads back to the negative
// axis.
class Contour {
 public:
  explicit Contour(const Problem& problem) : orders_(orders_of(problem)) {
    radius_ = std::pow(10.0, -std::clamp(6.0 / std::min(2.0, orders_.minCoeff()), 12.0, 300.0));
  }
  // For an equation, back at this distance from 0.
  Contour(const Problem& problem, double last) : Contour(problem) {
    last_ = std::max(last, 2.0 * radius_);
    beside_axis_ = 1e-9;  // where oscillations are not damped
    way_back_ = 1.0;
  }

  static constexpr double begin = -1.0;
  [[nodiscard]] double end() const { return ray() + way_back_; }

  // log zeta
  [[nodiscard]] ComplexValue at(double p) const {
    const double quarter = 0.5 * std::numbers::pi - beside_axis_;
    const double turned = beside_axis_ + quarter * (p < 0.0 ? -p : std::max(0.0, p - ray()));
    const double size = std::min(radius_ * std::exp(std::max(p, 0.0)), last_);
    return size * ComplexValue{-std::sin(turned), std::cos(turned)};
  }

  // Pieces on which the product of the powers (1-zeta)^g_i, or s^g_i, turns by at most a quarter.
  [[nodiscard]] int pieces() const {
    return static_cast<int>(std::ceil((end() - begin) * std::max(1.0, orders_.sum()) / 0.25));
  }

 private:
  [[nodiscard]] double ray() const { return std::log(last_ / radius_); }

  Vec orders_;
  double radius_ = 0.0, last_ = std::numbers::pi, beside_axis_ = 0.0, way_back_ = 0.0;
};

// The ends of pieces of a contour. On those where delays matter the power of zeta of the longest one turns by
// at most a radian, that of all rows together; `turns` is this power.
std::vector<double> points_along(const Contour& contour, double turns,
                                 const std::function<bool(double p)>& delays_matter_at) {
  constexpr double most = 1e6;
  std::vector<double> points{Contour::begin};
  std::vector<double> coarse = points;
  append_pieces(contour.end(), contour.pieces(), coarse);
  if (turns == 0.0) return coarse;
  for (std::size_t i = 1; i < coarse.size(); ++i) {
    const double from = coarse[i - 1], to = coarse[i];
    const double turned = turns * std::abs(contour.at(to) - contour.at(from));
    const bool followed = turned > 1.0 && (delays_matter_at(from) || delays_matter_at(0.5 * (from + to)) ||
                                           delays_matter_at(to));
    if (followed && static_cast<double>(points.size()) + turned > most)
      throw std::runtime_error("linear stability: the delays have too many steps");
    append_pieces(to, followed ? static_cast<int>(std::ceil(turned)) : 1, points);
  }
  return points;
}

// The zeros inside of a contour. turns: the power of zeta of the longest delay, times the rows; 0: no delays.
std::optional<int> count_zeros(const Contour& contour, const Symbol& symbol, const Symbol& without_delays,
                               double turns) {
  const auto log_symbol = [&](double p) {
    const ComplexMatrix matrix = symbol(contour.at(p));
    if (!matrix.allFinite()) throw std::runtime_error("linear stability: the symbol is beyond double");
    return log_determinant(matrix);
  };
  // Whether the factor det(I - X) of the determinant that has the earlier values may turn around 0. It does
  // not where the sum of the |eigenvalues| of X is below 1. It is at most sqrt(rows) |X|, whatever the
  // phases.
  const auto delays_matter_at = [&](double p) {
    constexpr double small = 0.75;
    const ComplexMatrix without = without_delays(contour.at(p));
    const ComplexMatrix x = without.partialPivLu().solve(symbol(contour.at(p)) - without);
    return !(std::sqrt(static_cast<double>(x.rows())) * x.norm() < small);
  };
  const double change = argument_change(log_symbol, points_along(contour, turns, delays_matter_at));
  // The lower half of the contour contributes the same change, because A is real.
  const double zeros = change / std::numbers::pi;
  if (!std::isfinite(zeros)) return std::nullopt;
  return static_cast<int>(std::lround(zeros));
}

// Why a problem has no modes to count, as part of a sentence.
std::optional<std::string_view> reason_without_modes(const Problem& problem) {
  if (!is_linear(problem)) return "the problem has no linear part";
  if (is_two_sided(problem)) return "the problem is posed at both ends";
  if (has_algebraic_rows(problem)) return "the problem has an algebraic row";
  return std::nullopt;
}

// The power of zeta of the longest delay, times the rows.
double turns_of_delays(const Problem& problem, double length) {
  const auto& lags = problem.delays.lags;
  return lags.empty() ? 0.0 : static_cast<double>(problem.size()) * lags.back() / length;
}

}  // namespace

Problem test_problem(const Scheme& scheme, double order, ComplexValue rate, double end, double delay) {
  if (delay > 0.0) return delayed_equation(order, 0.0, rate.real(), delay, end);
  return scheme.capabilities.discretises_equations ? scalar_multi_term_equation(order, rate, end)
                                                   : scalar_equation(order, rate, end);
}

Symbol symbol_of(const Scheme& scheme, const Problem& problem, double length) {
  const auto reject = [&](std::string_view reason) {
    throw std::invalid_argument(fmt::format("linear stability of {}: {}", scheme.id, reason));
  };
  if (!scheme.symbol) reject("the scheme has no symbol");
  if (const auto reason = reason_without_modes(problem)) reject(*reason);
  if (const auto reason = unsupported_reason(scheme, problem, Grid{length, 1})) reject(*reason);
  for (const double lag : problem.delays.lags) {
    constexpr double both_sides = 4.0;  // steps of the polynomials between results, as in StoredResults
    const double steps = steps_in(lag, length);
    if (steps >= both_sides || steps == std::round(steps)) continue;
    reject(fmt::format("a delay of {:.6g} is less than four steps of {:.6g} and no whole number of them", lag,
                       length));
  }
  return scheme.symbol(problem, length);
}

std::optional<int> count_growing_modes(const Scheme& scheme, const Problem& problem, double length) {
  const Symbol symbol = symbol_of(scheme, problem, length);
  const double turns = turns_of_delays(problem, length);
  if (turns == 0.0) return count_zeros(Contour(problem), symbol, symbol, turns);
  Problem without_delays = problem;
  without_delays.delays = {};
  return count_zeros(Contour(problem), symbol, symbol_of(scheme, without_delays, length), turns);
}

std::optional<int> count_growing_modes(const Problem& problem, double length) {
  if (const auto reason = reason_without_modes(problem))
    throw std::invalid_argument(fmt::format("linear stability of an equation: {}", *reason));
  const Vec orders = orders_of(problem), none = Vec::Zero(problem.size());
  const auto& lags = problem.delays.lags;
  const auto factors = delayed_jacobians_at(problem, 0.0, none, [](double, Out y) { y.setZero(); });
  const Vec scale = orders.unaryExpr([&](double g) { return std::pow(length, g); });
  const ComplexMatrix a = (scale.asDiagonal() * jacobian_at(problem, 0.0, none)).cast<ComplexValue>();
  Vec sums = a.cwiseAbs().rowwise().sum();
  for (const auto& one : factors) sums += scale.asDiagonal() * one.cwiseAbs().rowwise().sum();
  // From here on the powers of s are most of each row.
  constexpr double most = 8.0;
  double last = 0.0;
  for (Eigen::Index i = 0; i < orders.size(); ++i)
    last = std::max(last, std::pow(most * sums[i], 1.0 / orders[i]));
  const auto symbol = [&](bool with_delays) -> Symbol {
    return [&, with_delays](ComplexValue log_zeta) {
      ComplexMatrix s = -a;
      for (std::size_t k = 0; with_delays && k < lags.size(); ++k)
        s -= std::exp(log_zeta * (lags[k] / length)) * (scale.asDiagonal() * factors[k]);
      for (Eigen::Index i = 0; i < orders.size(); ++i) s(i, i) += std::pow(-log_zeta, orders[i]);
      return s;
    };
  };
  return count_zeros(Contour(problem, last), symbol(true), symbol(false), turns_of_delays(problem, length));
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
