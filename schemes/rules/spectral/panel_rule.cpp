// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_rule.hpp"

#include <Eigen/LU>
#include <boost/math/special_functions/legendre.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

#include "fdebench/schemes/stepping/setup_time.hpp"

namespace fde {
namespace {

// The matrices that all panels use are computed with more digits.
using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

template <class Points>
auto legendre(const Points& points, Eigen::Index count) {
  using Real = typename Points::Scalar;
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> p(points.size(), count);
  p.col(0).setOnes();
  if (count > 1) p.col(1) = points;
  for (Eigen::Index l = 1; l + 1 < count; ++l) {
    const auto degree = static_cast<Real>(l);
    p.col(l + 1) = ((2 * degree + 1) * points.cwiseProduct(p.col(l)) - degree * p.col(l - 1)) / (degree + 1);
  }
  return p;
}

// The zeros of P_n, increasing; boost returns those that are not negative.
Vec gauss_points(Eigen::Index count) {
  const auto zeros = boost::math::legendre_p_zeros<double>(static_cast<int>(count));
  Vec places(count);
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const auto from_middle = static_cast<Eigen::Index>(zeros.size() - 1 - i);
    places[count - 1 - from_middle] = zeros[i];
    places[from_middle] = -zeros[i];
  }
  return places;
}

// The zeros of P_n - P_(n-1), increasing: one between any two of P_n, and 1.
Vec radau_points(Eigen::Index count) {
  const auto degree = static_cast<int>(count);
  const auto radau = [degree](double x) {
    return boost::math::legendre_p(degree, x) - boost::math::legendre_p(degree - 1, x);
  };
  const Vec between = gauss_points(count);
  Vec places = Vec::Ones(count);
  for (Eigen::Index i = 0; i + 1 < count; ++i) {
    std::uintmax_t evaluations = 100;
    const auto [below, above] = boost::math::tools::toms748_solve(
        radau, between[i], between[i + 1], boost::math::tools::eps_tolerance<double>(), evaluations);
    places[i] = (below + above) / 2.0;
  }
  return places;
}

Vec gauss_weights(const Vec& places) {
  const auto count = static_cast<int>(places.size());
  return places.unaryExpr([count](double x) {
    const double slope = boost::math::legendre_p_prime(count, x);
    return 2.0 / ((1.0 - x * x) * slope * slope);
  });
}

}  // namespace

Matrix legendre_polynomials(const Vec& points, Eigen::Index count) { return legendre(points, count); }

PanelRule::PanelRule(Eigen::Index count) : points(radau_points(count)) {
  const auto at = [count](const Wide& x) { return legendre(Wide(x).col(0).eval(), count); };
  const auto older = [](const Wide& x) { return Wide((x.array() - 1) / 2); };
  const auto newer = [](const Wide& x) { return Wide((x.array() + 1) / 2); };
  const Wide x = points.cast<long double>();
  const Wide coefficients = at(x).inverse();
  to_coefficients = coefficients.cast<double>();
  at_end = coefficients.colwise().sum().transpose().cast<double>();
  at_start = (at(Wide::Constant(1, 1, -1)) * coefficients).transpose().cast<double>();
  to_older_half = (at(older(x)) * coefficients).cast<double>();
  to_newer_half = (at(newer(x)) * coefficients).cast<double>();
  const Vec norms = Vec::LinSpaced(count, 0.5, static_cast<double>(count) - 0.5);  // 1 / int P_l^2
  const Vec gauss = gauss_points(count);
  const Wide inner = gauss.cast<long double>();
  const Wide weighted = gauss_weights(gauss).cast<long double>().asDiagonal() * at(inner);
  const Wide half_norms = (norms / 2).cast<long double>().asDiagonal();
  from_older = (half_norms * at(older(inner)).transpose() * weighted).cast<double>();
  from_newer = (half_norms * at(newer(inner)).transpose() * weighted).cast<double>();
}

const PanelRule& panel_rule(Eigen::Index points) {
  struct Retained {
    PanelRule rule;
    double seconds;
  };
  static std::mutex mutex;
  static std::map<Eigen::Index, Retained> made;
  const std::scoped_lock lock(mutex);
  auto found = made.find(points);
  if (found == made.end()) {
    const double start = thread_seconds();
    PanelRule rule(points);
    found = made.emplace(points, Retained{std::move(rule), thread_seconds() - start}).first;
  }
  count_table(&found->second, found->second.seconds);
  return found->second.rule;
}

}  // namespace fde
