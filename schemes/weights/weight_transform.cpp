#include "weights/weight_transform.hpp"

#include <cmath>
#include <cstdlib>

namespace fde {
namespace {

// D(s) = (exp(s) - 1) / s = int_0^1 exp(v s) dv.
double unit_integral(double s) { return s == 0.0 ? 1.0 : std::expm1(s) / s; }

// (D(s) - 1) / s = sum_k s^k / (k+2)!, for the moderate s >= 0 of the nodes.
double half_hat(double s) {
  double term = 0.5, sum = term;
  for (int k = 3; term > 1e-18 * sum; ++k) {
    term *= s / k;
    sum += term;
  }
  return sum;
}

double factor(const WeightTable& table, double s) {
  const double g = table.order, d = unit_integral(s), summed = weighs_running_sums(table) ? d : 1.0;
  switch (table.family) {
    case WeightFamily::rectangle:
      return std::tgamma(g + 1) * d * summed;
    case WeightFamily::trapezoid:
      return std::tgamma(g + 2) * d * d * std::exp(-s) * summed;
    case WeightFamily::grunwald_letnikov:
      return std::pow(d, -static_cast<double>(kernel_exponent(table)));
    case WeightFamily::l1:
      return std::tgamma(2 - g) * d * std::exp(-s);
  }
  std::abort();
}

}  // namespace

long double kernel_exponent(const WeightTable& table) {
  if (table.family == WeightFamily::l1) return 1.0L - table.order;
  return weighs_running_sums(table) ? table.order - 1.0 : table.order;
}

bool weighs_running_sums(const WeightTable& table) { return table.order > 1.0; }

Vec weight_coefficients(const WeightTable& table, const ExponentialSum& sum) {
  return sum.coefficients.cwiseProduct(sum.nodes.unaryExpr([&](double s) { return factor(table, s); }));
}

Vec start_coefficients(const WeightTable& table, const ExponentialSum& sum) {
  const double scale = std::tgamma(table.order + 2.0);
  return scale * sum.coefficients.cwiseProduct(sum.nodes.unaryExpr([&](double s) {
    return half_hat(s) * (weighs_running_sums(table) ? unit_integral(s) : 1.0);
  }));
}

}  // namespace fde
