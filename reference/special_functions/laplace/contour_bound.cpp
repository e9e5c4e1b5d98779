// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "fdebench/reference/special_functions/numbers/constants.hpp"
#include "fdebench/reference/special_functions/numbers/reciprocal_gamma.hpp"

namespace fde::reference {
namespace {

// log of 1 / (e^(omega |1-distance|) - 1).
double log_of_factor(double omega, double distance) {
  const double turns = omega * std::abs(1.0 - distance);
  return -turns - std::log1p(-std::exp(-turns));
}

// Whether s* = mu root^2 is so far to the left that e^s is negligible wherever |s| > |s*| / 2. The square
// roots of points nearer to 0 are more than a fifth of |Re root| + |Im root| away from root.
bool is_negligible(std::complex<double> root, double mu) {
  constexpr double nothing = 1e7;
  const double re = root.real() * root.real(), im = root.imag() * root.imag();
  return im > 2.0 * re && mu * im > nothing;
}

// log of min(1, alpha distance) / 10, distance being a lower bound of |log s - log s*| for all poles and all
// points with |r - r*| >= gap(r*).
template <class Gap>
double log_clearance(const ContourBound::Quotient& quotient, double mu, const Gap& gap) {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();  // of the roots
  double ratio = std::numeric_limits<double>::infinity();
  for (const auto& root : quotient.roots) {
    const double relative = gap(root) / (std::abs(root.real()) + std::abs(root.imag())) - rounding;
    ratio = std::min(ratio, is_negligible(root, mu) ? 0.2 : relative);
  }
  if (!(ratio > 0.0)) return -std::numeric_limits<double>::infinity();
  const double others = std::min(1.0, quotient.nearest_other_argument - quotient.alpha * pi_double);
  const double poles = quotient.roots.empty() ? 1.0 : 2.0 * quotient.alpha / (1.0 + 1.0 / ratio);
  const double distance = std::min(others, poles);
  return distance > 0.0 ? std::log(distance / 10.0) : -std::numeric_limits<double>::infinity();
}

double log_clearance_of_line(const ContourBound::Quotient& quotient, double mu, double distance) {
  return log_clearance(quotient, mu,
                       [&](std::complex<double> root) { return std::abs(root.real() - distance); });
}

}  // namespace

double ContourShape::step() const { return 2.0 * pi_double / omega; }

double ContourShape::steps_to_node(std::complex<double> root) const {
  const double along = root.imag() / step() - (half_step_shift ? 0.5 : 0.0);
  return std::max(std::abs(along - std::round(along)), std::abs(root.real() - 1.0) / step());
}

// |ds| = 2 mu |d + i x| dx. For exponents e > 0 the smaller of two bounds: with L = mu d^2 and, for every
// 0 < p < 1,
//   (d^2 + x^2)^e <= p^-max(0,e-1) d^(2e) + (1-p)^-max(0,e-1) x^(2e)   (convexity),
// or, with v = |s| = L + mu x^2, where the integrand is e^(2L) e^-v v^e, and q = 1/(1+e),
//   e^-v v^e <= e^(-q v) max_u e^(-(1-q) u) u^e = e^(-q v) (e / (1-q))^e e^-e.
double log_line_integral(double mu, double distance, double exponent) {
  const double least = mu * distance * distance;
  const auto log_length = [&](double q) {
    return std::log(distance * std::sqrt(pi_double * mu / q) + 1.0 / q);
  };
  const double near = exponent * std::log(least) + log_length(1.0);
  if (exponent <= 0.0) return least + near - std::log(pi_double);
  const double far =
      log_sum(std::log(distance * std::sqrt(mu)) + log_gamma(exponent + 0.5), log_gamma(exponent + 1.0));
  const auto split = [&](double p) {
    const double power = std::max(0.0, exponent - 1.0);
    return least + log_sum(near - power * std::log(p), far - power * std::log1p(-p));
  };
  const double q = 1.0 / (1.0 + exponent);
  const double largest = exponent * (std::log(exponent) - std::log1p(-q) - 1.0);
  const double whole = (2.0 - q) * least + largest + log_length(q);
  return std::min({split(0.5), split(q), whole}) - std::log(pi_double);
}

namespace {
constexpr int least_exponent = -64, most_exponent = 64;
}

LineIntegrals::LineIntegrals(double mu, double distance) : mu_(mu), distance_(distance) {
  for (int e = least_exponent; e <= most_exponent; ++e) logs_.push_back(log_line_integral(mu, distance, e));
}

double LineIntegrals::log_at(double exponent) const {
  const double place = exponent - least_exponent;
  if (!(place >= 0.0 && exponent < most_exponent)) return log_line_integral(mu_, distance_, exponent);
  const auto below = static_cast<std::size_t>(place);
  return std::lerp(logs_[below], logs_[below + 1], place - std::floor(place));
}

ContourBound::ContourBound(const ContourShape& shape) : shape_(shape) {
  for (const double factor :
       {2.0, 4.0}) {  // for F that varies slowly, and for F that oscillates as fast as e^s
    const double distance = shape.omega / (factor * shape.mu);
    far_lines_.push_back({distance, log_of_factor(shape.omega, distance), LineIntegrals(shape.mu, distance)});
  }
  for (double distance = 1.0 / shape.omega; distance < 0.9; distance *= 3.0) {
    near_lines_.push_back(
        {distance, log_of_factor(shape.omega, distance), LineIntegrals(shape.mu, distance)});
  }
}

double ContourBound::log_line(const Line& at, const Quotient& quotient) const {
  const LineIntegrals& line = at.integrals;
  const double size = std::min(line.log_at(quotient.exponent - quotient.alpha),
                               line.log_at(quotient.exponent) - quotient.log_size);
  return size + at.log_factor - log_clearance_of_line(quotient, shape_.mu, at.distance);
}

double ContourBound::log_integral(double mu, double distance, const Quotient& quotient) {
  const double size = std::min(log_line_integral(mu, distance, quotient.exponent - quotient.alpha),
                               log_line_integral(mu, distance, quotient.exponent) - quotient.log_size);
  return size - log_clearance_of_line(quotient, mu, distance);
}

// A geometric series from the first truncated node theta on, with the conjugate nodes.
double ContourBound::log_truncation_error(const Quotient& quotient) const {
  const double step = shape_.step(), mu = shape_.mu, theta = std::sqrt(1.0 + shape_.depth / mu);
  const double modulus = mu * (1.0 + theta * theta), e = quotient.exponent;
  const double power =
      std::min((e - quotient.alpha) * std::log(modulus), e * std::log(modulus) - quotient.log_size);
  const double ratio = std::exp(-2.0 * mu * theta * step + std::max(0.0, 2.0 * e + 1.0) * step / theta);
  if (!(ratio < 1.0)) return std::numeric_limits<double>::infinity();
  const double weight = std::log(2.0 * step * std::sqrt(mu * modulus) / pi_double) - shape_.depth;
  const double clearance = log_clearance(
      quotient, mu, [&](std::complex<double> root) { return shape_.steps_to_node(root) * step; });
  return weight + power - std::log1p(-ratio) - clearance;
}

ContourBound::Result ContourBound::bound_for(const Quotient& quotient) const {
  Result best{std::numeric_limits<double>::infinity(), near_lines_.front().distance};
  for (const Line& line : near_lines_) {
    const double bound = log_line(line, quotient);
    if (bound < best.log_bound) best = {bound, line.distance};
  }
  constexpr double negligible = 10.0;
  double far = log_line(far_lines_[0], quotient);
  if (far > best.log_bound - negligible) far = std::min(far, log_line(far_lines_[1], quotient));
  best.log_bound = log_sum(best.log_bound, log_sum(far, log_truncation_error(quotient)));
  return best;
}

}  // namespace fde::reference
