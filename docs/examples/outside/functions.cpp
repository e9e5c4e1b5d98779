#include <complex>
#include <cstdio>

#include <fdebench/reference/special_functions/special_functions.hpp>

// E_{1/2,1}(-1) = e erfc(1) in double, in forty digits, and of the matrix (-1 1; 0 -1), whose entry beside
// the diagonal is the derivative at -1.
int main() {
  const std::complex<double> one = 1.0;
  const auto [value, bound] = fde::reference::mittag_leffler(0.5, 1.0, -one);
  std::printf("%.17g within %.0e\n", value.real(), bound);
  const fde::reference::DecimalComplex digits = fde::reference::mittag_leffler("0.5", "1", "-1", "0", 40);
  std::printf("%s within %s\n", digits.re.c_str(), digits.bound.c_str());
  Eigen::MatrixXcd block(2, 2);
  block << -1.0, 1.0, 0.0, -1.0;
  const fde::reference::MatrixValue of_block = fde::reference::mittag_leffler(0.5, 1.0, block);
  const auto [slope, bound_of_slope] = fde::reference::mittag_leffler_derivative(1, 0.5, 1.0, -one);
  std::printf("%.15f = %.15f\n", of_block.value(0, 1).real(), slope.real());
}
