// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/contour.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>
#include <tuple>

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

template <class Real>
Contour<Real>::Contour(const Real& mu, const Real& omega, const Real& depth, bool half_step_shift)
    : mu_(mu),
      omega_(omega),
      depth_(depth),
      shift_(half_step_shift ? Real(1) / 2 : Real(0)),
      exp_minus_mu_(0) {
  using std::exp, std::log, std::sqrt;
  exp_minus_mu_ = exp(-mu);
  const Real step = 2 * pi<Real>() / omega;
  const Real end = sqrt(1 + depth / mu);  // mu (1 - theta^2) = -depth
  const Real log_mu = log(mu), scale = step * mu / pi<Real>();
  const auto count = static_cast<std::size_t>(static_cast<double>(end / step)) + 1;
  for (int k = 0;; ++k) {
    const Real theta = (k + shift_) * step;
    if (theta > end) break;
    if constexpr (std::is_same_v<Real, BigReal>) report_progress(static_cast<std::size_t>(k), count);
    const Complex<Real> root(Real(1), theta);
    const Complex<Real> s(mu * (1 - theta * theta), 2 * mu * theta);
    const Real half = theta == 0 ? Real(1) / 2 : Real(1);  // its own conjugate, would be counted twice
    nodes_.push_back({s, log_mu + Real(2) * Complex<Real>(log(root)), half * scale * root * exp(s)});
  }
}

template <class Real>
ContourShape Contour<Real>::shape() const {
  return {static_cast<double>(mu_), static_cast<double>(omega_), static_cast<double>(depth_), shift_ != 0};
}

template <class Real>
Complex<Real> Contour<Real>::step_of(const Complex<Real>& log_pole) const {
  using std::exp, std::sqrt;
  // theta = -i (sqrt(s/mu) - 1)
  const Complex<Real> root = exp(log_pole / Real(2)) / sqrt(mu_) - Real(1);
  const Real per_step = omega_ / (2 * pi<Real>());
  return {imag_part<Real>(root) * per_step - shift_, -real_part<Real>(root) * per_step};
}

template <class Real>
Complex<Real> Contour<Real>::pole_factor(const Complex<Real>& log_pole) const {
  using std::exp, std::log;
  const Complex<Real> position = step_of(log_pole);
  const Real turn = 2 * pi<Real>();
  const Complex<Real> exponent(turn * imag_part<Real>(position), -turn * real_part<Real>(position));
  // Exact to the last digit; mpc would spend its time on the digits of a negligible imaginary part.
  const Real nothing = 2 * log(epsilon<Real>());
  if (real_part<Real>(exponent) < nothing) return Complex<Real>(1);
  if (real_part<Real>(exponent) > -nothing) return -exp(-exponent);
  return Real(1) / (Real(1) - exp(exponent));
}

template <class Real>
bool Contour<Real>::at_branch_point(const Complex<Real>& log_pole) const {
  using std::log;
  return real_part<Real>(log_pole) < log(mu_ / (omega_ * omega_));
}

template <class Real>
Real Contour<Real>::steps_to_node(const Complex<Real>& log_pole) const {
  using std::abs, std::floor;
  const Complex<Real> position = step_of(log_pole);
  const Real along = real_part<Real>(position);
  return abs(Real(along - floor(along + Real(1) / 2))) + abs(imag_part<Real>(position));
}

template class Contour<long double>;
template class Contour<BigReal>;

namespace {

// mu = omega / 8 and depth = omega balance the three errors; the terms then exceed f by up to e^mu. 8.3 in
// place of 8: with 8, Im s is an integer multiple of pi/2, where the last bits of a sine or cosine take MPFR
// ten times longer.
constexpr double growth = 8.3;

double omega_for(int digits) { return std::numbers::ln10 * digits + 10.0; }

}  // namespace

const Contour<BigReal>& contour_for(int digits, double exponent) {
  constexpr std::size_t most = 32;
  constexpr double moderate = 8.0;
  static std::map<std::tuple<int, double, unsigned>, Contour<BigReal>>
      known;  // guarded by the lock of Precision
  const double large = std::abs(exponent) <= moderate ? 0.0 : moderate * std::round(exponent / moderate);
  const std::tuple key{digits, large, BigReal::default_precision()};
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  const double wanted = omega_for(digits);
  const double mu = large > 0.0 ? wanted / (2.0 * growth) : std::max(wanted / growth, -large);
  const BigReal omega(std::max(wanted, growth * mu)), depth(wanted + 3.0 * std::max(0.0, large));
  return known.try_emplace(key, BigReal(mu), omega, depth, false).first->second;
}

int contour_precision(int digits) {
  return digits + static_cast<int>(omega_for(digits) / growth / std::numbers::ln10) + 8;
}

const Contour<long double>& contour_away_from(const std::vector<Complex<long double>>& log_poles) {
  // A smaller mu than the balanced one: e^mu costs digits, of which there are few, and nodes are cheap.
  static const std::array<Contour<long double>, 2> contours{Contour<long double>(1.5L, 54.0L, 50.0L, false),
                                                            Contour<long double>(1.5L, 54.0L, 50.0L, true)};
  const auto clearance = [&](const Contour<long double>& contour) {
    long double least = 1.0L;
    for (const auto& pole : log_poles) least = std::min(least, contour.steps_to_node(pole));
    return least;
  };
  return clearance(contours[0]) >= clearance(contours[1]) ? contours[0] : contours[1];
}

namespace {

DigitSearchOptions search_for(int wanted_digits) {
  return {.target_digits = wanted_digits, .guard = 8, .next_digits = [](int digits, int missing) {
            return digits + missing + 2;
          }};
}

std::vector<BoundedSum<BigReal>> evaluate_at(const EvaluateAt& evaluate, int digits, int extra) {
  const Precision precision(contour_precision(digits) + extra);
  return evaluate(digits);
}

}  // namespace

std::vector<Bounded<BigReal>> increase_digits_by_comparison(int wanted_digits, int extra,
                                                            const EvaluateAt& evaluate) {
  const auto compared = [&](int digits) {
    const auto coarse = evaluate_at(evaluate, digits, extra);
    const auto fine = evaluate_at(evaluate, digits + std::max(10, digits / 16), extra);
    std::vector<WorkingEstimate> estimates;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const BigComplex difference = fine[i].value - coarse[i].value;
      estimates.push_back({.value_and_bound = {fine[i].value, BigReal(4 * norm1(difference) + fine[i].error)},
                           .scale = fine[i].scale,
                           .is_final = fine[i].overflows});
    }
    return estimates;
  };
  return increase_digits(search_for(wanted_digits), compared).values;
}

Bounded<BigReal> increase_digits_by_bound(int wanted_digits, int extra,
                                          const std::function<BoundedSum<BigReal>(int digits)>& evaluate) {
  const auto bounded = [&](int digits) {
    const Precision precision(contour_precision(digits) + extra);
    const BoundedSum<BigReal> sum = evaluate(digits);
    return std::vector<WorkingEstimate>{
        {.value_and_bound = {sum.value, sum.error}, .is_final = sum.overflows}};
  };
  const DigitSearchResult raised = increase_digits(search_for(wanted_digits), bounded);
  if (raised.largest_missed_bound)
    throw std::runtime_error(fmt::format("no accurate value within {} digits", raised.digits));
  return raised.values.front();
}

}  // namespace fde::reference
