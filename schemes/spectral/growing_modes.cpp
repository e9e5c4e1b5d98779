#include "spectral/growing_modes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace fde {
namespace {

// det(1 - diag(s^-orders) jacobian), which tends to 1 far out; s = e^log_s.
std::complex<double> determinant(const Matrix& jacobian, const Vec& orders, std::complex<double> log_s) {
  ComplexMatrix matrix = ComplexMatrix::Identity(orders.size(), orders.size());
  for (Eigen::Index i = 0; i < orders.size(); ++i)
    matrix.row(i) -= std::exp(-orders[i] * log_s) * jacobian.row(i);
  return matrix.determinant();
}

}  // namespace

// The path goes a quarter round 0 from the real axis, up the imaginary axis to where the rows of the identity
// outweigh the others, and a quarter back to the real axis: at both ends the determinant is real. With its
// mirror image the path encloses the modes, each of which turns the determinant once, half of it here.
bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate) {
  using namespace std::complex_literals;
  constexpr double turn = 0.3, clear = 1.01;  // of s^order in a step; of the other entries of a row
  constexpr double most_steps = 1e4;
  const double first = std::log(rate), largest = orders.maxCoeff();
  double last = first;
  for (Eigen::Index i = 0; i < orders.size(); ++i) {
    const double others = clear * jacobian.row(i).cwiseAbs().sum();
    if (others > 0.0) last = std::max(last, std::log(others) / orders[i]);
  }
  if (!(last > first)) return false;
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
