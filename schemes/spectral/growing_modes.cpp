#include "spectral/growing_modes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace fde {
namespace {

// det(1 - diag(s^-orders) jacobian), which tends to 1 far out, without the 1 in algebraic rows, which make it
// tend to a power of s; s = e^log_s.
std::complex<double> determinant(const Matrix& jacobian, const Vec& orders, std::complex<double> log_s) {
  ComplexMatrix matrix = ComplexMatrix::Identity(orders.size(), orders.size());
  for (Eigen::Index i = 0; i < orders.size(); ++i)
    matrix.row(i) -= std::exp(-orders[i] * log_s) * jacobian.row(i);
  for (Eigen::Index i = 0; i < orders.size(); ++i) {
    if (orders[i] == 0.0) matrix(i, i) -= 1.0;
  }
  return matrix.determinant();
}

// From where on it is a power of s, as far as two distances can tell; NaN: nowhere.
double power_from(const Matrix& jacobian, const Vec& orders, double log_s) {
  constexpr double straight = 0.02, most = 300.0;  // of log |det| against log s; of log s
  const auto slope = [&](double at) {
    return std::log(std::abs(determinant(jacobian, orders, at + 1.0) / determinant(jacobian, orders, at)));
  };
  for (; log_s < most; log_s += 1.0) {
    if (std::abs(slope(log_s + 2.0) - slope(log_s)) < straight) return log_s;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

// The path goes a quarter round 0 from the real axis, up the imaginary axis to where the rows of the identity
// outweigh the others, or the determinant is a power of s, and a quarter back to the real axis: at both ends
// the determinant is real. With its mirror image the path encloses the modes, each of which turns the
// determinant once, half of it here.
bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate) {
  using namespace std::complex_literals;
  constexpr double turn = 0.3, clear = 1.01;  // of s^order in a step; of the other entries of a row
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
