#include "spectral/panel_rule.hpp"

#include <boost/math/special_functions/legendre.hpp>

namespace fde {
namespace {

// The zeros of P_n, increasing; the library has those that are not negative.
Vec gauss_places(Eigen::Index count) {
  const auto zeros = boost::math::legendre_p_zeros<double>(static_cast<int>(count));
  Vec places(count);
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const auto from_middle = static_cast<Eigen::Index>(zeros.size() - 1 - i);
    places[count - 1 - from_middle] = zeros[i];
    places[from_middle] = -zeros[i];
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

Matrix legendre_polynomials(const Vec& points, Eigen::Index count) {
  Matrix p(points.size(), count);
  p.col(0).setOnes();
  if (count > 1) p.col(1) = points;
  for (Eigen::Index l = 1; l + 1 < count; ++l) {
    const auto degree = static_cast<double>(l);
    p.col(l + 1) =
        ((2.0 * degree + 1.0) * points.cwiseProduct(p.col(l)) - degree * p.col(l - 1)) / (degree + 1.0);
  }
  return p;
}

PanelRule::PanelRule(Eigen::Index points) : places(gauss_places(points)) {
  const Vec weights = gauss_weights(places);
  const Vec norms = Vec::LinSpaced(points, 0.5, static_cast<double>(points) - 0.5);  // 1 / int P_l^2
  const Vec older = (places.array() - 1.0) / 2.0, newer = (places.array() + 1.0) / 2.0;
  const Matrix at_places = legendre_polynomials(places, points);
  const Matrix at_older = legendre_polynomials(older, points), at_newer = legendre_polynomials(newer, points);
  to_coefficients = norms.asDiagonal() * at_places.transpose() * weights.asDiagonal();
  at_end = to_coefficients.colwise().sum().transpose();
  at_start = (legendre_polynomials(Vec::Constant(1, -1.0), points) * to_coefficients).transpose();
  older_half = at_older * to_coefficients;
  newer_half = at_newer * to_coefficients;
  from_older = 0.5 * norms.asDiagonal() * at_older.transpose() * weights.asDiagonal() * at_places;
  from_newer = 0.5 * norms.asDiagonal() * at_newer.transpose() * weights.asDiagonal() * at_places;
}

}  // namespace fde
