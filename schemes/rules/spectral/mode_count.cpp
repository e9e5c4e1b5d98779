// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/mode_count.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace fde {
namespace {

// det(1 - diag(s^-orders) jacobian), without the 1 in algebraic rows; s = e^log_s. For large |s| it tends to
// 1, or to a power of s where there are algebraic rows.
std::complex<double> determinant(const Matrix& jacobian, const Vec& orders, std::complex<double> log_s) {
  ComplexMatrix matrix = ComplexMatrix::Identity(orders.size(), orders.size());
  for (Eigen::Index i = 0; i < orders.size(); ++i)
    matrix.row(i) -= std::exp(-orders[i] * log_s) * jacobian.row(i);
  for (Eigen::Index i = 0; i < orders.size(); ++i) {
    if (orders[i] == 0.0) matrix(i, i) -= 1.0;
  }
  return matrix.determinant();
}

// The log |s| from which on the determinant is a power of s, judged by its slopes at two distances; NaN:
// none.
double power_from(const Matrix& jacobian, const Vec& orders, double log_s) {
  constexpr double straight = 0.02, most = 300.0;  // change of d log |det| / d log s; largest log s
  const auto slope = [&](double at) {
    return std::log(std::abs(determinant(jacobian, orders, at + 1.0) / determinant(jacobian, orders, at)));
  };
  for (; log_s < most; log_s += 1.0) {
    if (std::abs(slope(log_s + 2.0) - slope(log_s)) < straight) return log_s;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

// The path is a quarter circle round 0 from the real axis, a part of the imaginary axis up to where the
// identity dominates the other entries of each row, or the determinant is a power of s, and a quarter circle
// back to the real axis: at both ends the determinant is real. With its mirror image the path encloses the
// modes. Each of them adds a full turn to the argument of the determinant, half of it on this path.
bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate) {
  using namespace std::complex_literals;
  constexpr double turn = 0.3, clear = 1.01;  // of log(s^order) a step; times the other entries of a row
  constexpr double most_steps = 1e4;
  const double first = std::log(rate), largest = orders.maxCoeff();
  double last = first;
  for (Eigen::Index i = 0; i < orders.size(); ++i) {
    const double others = clear * jacobian.row(i).cwiseAbs().sum();
    if (others > 0.0 && orders[i] > 0.0) last = std::max(last, std::log(others) / orders[i]);
  }
  if (orders.minCoeff() == 0.0) last = power_from(jacobian, orders, last);
  if (last <= first) return false;
  if (!((last - first) * largest < turn * most_steps)) return true;
  auto before = determinant(jacobian, orders, first);
  double turned = 0.0;
  const auto go = [&](std::complex<double> from, std::complex<double> to) {
    const auto steps = static_cast<int>(std::ceil(std::abs(to - from) * largest / turn));
    for (int k = 1; k <= steps; ++k) {
      const auto now = determinant(jacobian, orders, from + (to - from) * (static_cast<double>(k) / steps));
      turned += std::arg(now / before);
      before = now;
    }
  };
  const auto quarter = 0.5i * std::numbers::pi;
  go(first, first + quarter);
  go(first + quarter, last + quarter);
  go(last + quarter, last);
  return std::abs(turned) > 0.5 * std::numbers::pi;
}

}  // namespace fde
