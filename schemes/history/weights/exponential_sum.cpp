// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/weights/exponential_sum.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace fde {

namespace {

using Real = long double;
using RealVec = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

constexpr double largest_step = 0.7;

// Relative error of the trapezoidal rule with step h on the whole line. Poisson's summation formula gives the
// integrals with the factors exp(2 pi i l x / h); rotating their paths to arg s = theta gives the factors
// exp(-2 pi l theta / h) and at most 1/cos(theta). theta = pi/2 - h/(2 pi) is nearly optimal.
double step_error(double h) {
  constexpr double turn = 2 * std::numbers::pi;
  const double spare = h / turn, gain = std::exp(-turn / h * (turn / 4 - spare));
  return 2 / std::sin(spare) * gain / (1 - gain);
}

// The largest step h with step_error(h) <= error.
double step_of(double error) {
  double low = 0.01, high = largest_step;
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    (step_error(middle) > error ? high : low) = middle;
  }
  return low;
}

// A Gauss rule with `count` nodes that replaces the nodes up to theta / high.
struct Tail {
  int count;
  double theta, error;
};

// Relative error of the n-point Gauss rule. The rule is exact for polynomials of degree 2n - 1, so its error
// is at most twice the mass times the distance of exp(-s t) from these polynomials. That distance is bounded
// on the ellipse with foci at the ends of the interval and a sum of half axes of rho half intervals.
// The logarithm of the error; theta = 4 (2n - 1) / rho is about the best for given n and rho.
double log_tail_error(int n, double log_theta, double rho, double log_rho, double a) {
  constexpr double mass =
      1.6;  // at most h (1-a) / (1 - q^(1-a)) / Gamma(2-a), for any step up to largest_step
  const int exact = 2 * n - 1;
  const double largest = 2 * exact / rho * ((rho + 1 / rho) / 2 - 1);
  return std::log(4 * mass / (rho - 1)) + (1 - a) * log_theta + largest - exact * log_rho;
}

// The Gauss rule with at most this error for which the total number of nodes is smallest; a node of the
// trapezoidal rule covers a factor exp(h).
Tail best_tail(double error, double a, double h) {
  Tail best{};
  const double most = std::log(error);
  double fewest = std::numeric_limits<double>::infinity();
  int n = 1;
  for (double rho = 6; rho < 60; rho *= 1.1) {  // the larger rho, the smaller n
    const double log_rho = std::log(rho);
    const auto log_theta = [=](int points) { return std::log(4 * (2 * points - 1)) - log_rho; };
    const auto log_error = [=](int points) {
      return log_tail_error(points, log_theta(points), rho, log_rho, a);
    };
    while (log_error(n) > most) ++n;
    while (n > 1 && log_error(n - 1) <= most) --n;
    const double nodes = n - log_theta(n) / h;
    if (nodes >= fewest) continue;
    fewest = nodes;
    best = {n, std::exp(log_theta(n)), std::exp(log_error(n))};
  }
  return best;
}

// Relative contribution at t = low of the nodes from s upwards, times Gamma(1-a): the first, and an integral
// that bounds the others.
double cut_error(double s, double low, double a, double h) {
  const double x = s * low;
  return (1 + h * x) * std::exp(-x - a * std::log(x));
}

// Gauss rule of the measure with the masses h s_i^(1-a) at s_i = sigma q^i, i >= 0, q = exp(-h), by Golub and
// Welsch from the recurrence of the little q-Jacobi polynomials with b = 1 and aq = q^(1-a) (Koekoek, Lesky &
// Swarttouw 2010, 14.12).
struct GaussRule {
  RealVec nodes, weights;
};
GaussRule gauss_rule(int n, Real sigma, Real a, Real h) {
  const auto below_one = [h](Real power) { return -std::expm1(-h * power); };  // 1 - q^power
  RealVec diagonal(n), off_diagonal(n - 1);
  Real last_up = 0;
  for (int k = 0; k < n; ++k) {
    const Real shift = 2 * k - a;
    const Real up = std::exp(-h * k) * below_one(k + 1 - a) * below_one(k + 1 - a) /
                    (below_one(shift + 1) * below_one(shift + 2));
    const Real down = k == 0 ? 0
                             : std::exp(-h * (k - a)) * below_one(k) * below_one(k) /
                                   (below_one(shift) * below_one(shift + 1));
    diagonal[k] = up + down;
    if (k > 0) off_diagonal[k - 1] = std::sqrt(last_up * down);
    last_up = up;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>> solver;
  solver.computeFromTridiagonal(diagonal, off_diagonal, Eigen::EigenvaluesOnly);
  const Real mass = h * std::pow(sigma, 1 - a) / below_one(1 - a);
  // The first entries of the eigenvectors: 1 / sum_k p_k^2 with the orthonormal polynomials p_k at a node.
  RealVec weights(n);
  for (int i = 0; i < n; ++i) {
    Real before = 0, now = 1, sum = 1;
    for (int k = 0; k + 1 < n; ++k) {
      const Real last = k == 0 ? 0 : off_diagonal[k - 1] * before;
      before = std::exchange(now, ((solver.eigenvalues()[i] - diagonal[k]) * now - last) / off_diagonal[k]);
      sum += now * now;
    }
    weights[i] = mass / sum;
  }
  return {sigma * solver.eigenvalues(), weights};
}

void check(long double exponent, double low, double high, double tolerance) {
  if (exponent > 0 && exponent <= 1 && low > 0.0 && high > low && std::isfinite(high) && tolerance > 0.0 &&
      tolerance < 1.0) {
    return;
  }
  throw std::invalid_argument(
      fmt::format("exponential_sum({}, {}, {}, {}): needs an exponent in (0, 1], 0 < low < high < inf and a "
                  "tolerance in (0, 1)",
                  exponent, low, high, tolerance));
}

// The Gauss rule, and the nodes exp(m h) of the trapezoidal rule, first < m <= last.
struct Discretisation {
  double h;
  Tail tail;
  int first, last;
  double cut;  // cut_error of the nodes that are left out
};
Discretisation discretisation(double a, double low, double high, double tolerance) {
  const double share = tolerance / 3, h = step_of(share);
  const Tail tail = best_tail(share, a, h);
  const auto first = static_cast<int>(std::floor(std::log(tail.theta / high) / h));
  const double gamma = std::tgamma(1 - a);
  int last = first;
  const auto cut = [&] { return cut_error(std::exp((last + 1) * h), low, a, h) / gamma; };
  while (cut() > share) ++last;
  return {h, tail, first, last, cut()};
}

template <typename Coefficient>
Vec transformed(Coefficient coefficient, double order, const ExponentialSum& sum) {
  return sum.nodes.binaryExpr(sum.coefficients,
                              [&](double node, double kernel) { return coefficient(order, node, kernel); });
}

}  // namespace

ExponentialSum exponential_sum(long double exponent, double low, double high, double tolerance) {
  check(exponent, low, high, tolerance);
  if (exponent == 1) return {Vec::Zero(1), Vec::Ones(1), 0.0};
  const auto [h, tail, first, last, cut] =
      discretisation(static_cast<double>(exponent), low, high, tolerance);
  constexpr Real pi = std::numbers::pi_v<Real>;
  const Real a = exponent, step = h, scale = std::sin(pi * std::min(a, 1 - a)) / pi;
  const GaussRule rule = gauss_rule(tail.count, std::exp(first * step), a, step);
  ExponentialSum sum{Vec(tail.count + last - first), Vec(tail.count + last - first),
                     step_error(h) + tail.error + cut};
  sum.nodes.head(tail.count) = rule.nodes.cast<double>();
  sum.coefficients.head(tail.count) = (scale * rule.weights).cast<double>();
  for (int m = first + 1; m <= last; ++m) {
    const Eigen::Index row = tail.count + m - first - 1;
    sum.nodes[row] = static_cast<double>(std::exp(m * step));
    sum.coefficients[row] = static_cast<double>(scale * step * std::exp(m * step * (1 - a)));
  }
  return sum;
}

long double kernel_exponent(const WeightTable& table) {
  if (table.family->exponent != nullptr) return table.family->exponent(table.order);
  if (table.family->acts_on_increments) return 1.0L - table.order;
  return acts_on_running_sums(table) ? table.order - 1.0 : table.order;
}

bool acts_on_running_sums(const WeightTable& table) {
  return table.order > 1.0 && table.family->exponent == nullptr;
}

bool has_exponential_sum(const WeightTable& table) {
  const auto& family = *table.family;
  return family.coefficient != nullptr || family.filter != nullptr || family.smooth_part != nullptr;
}

Vec weight_coefficients(const WeightTable& table, const ExponentialSum& sum) {
  return transformed(table.family->coefficient, table.order, sum);
}

Vec first_sample_coefficients(const WeightTable& table, const ExponentialSum& sum) {
  return transformed(table.family->first_sample_coefficient, table.order, sum);
}

}  // namespace fde
