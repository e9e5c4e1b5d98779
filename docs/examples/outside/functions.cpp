#include <complex>
#include <cstdio>

#include <fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp>
#include <fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp>
#include <fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp>

// E_{1/2,1}(-1) = e erfc(1) in double, in forty digits, and of the matrix (-1 1; 0 -1), whose entry beside
// the diagonal is the derivative at -1.
int main() {
  const std::complex<double> one = 1.0;
  const auto [value, bound] = fde::mittag_leffler(0.5, 1.0, -one);
  std::printf("%.17g within %.0e\n", value.real(), bound);
  const fde::DecimalComplex digits = fde::mittag_leffler("0.5", "1", "-1", "0", 40);
  std::printf("%s within %s\n", digits.re.c_str(), digits.bound.c_str());
  Eigen::MatrixXcd block(2, 2);
  block << -1.0, 1.0, 0.0, -1.0;
  const fde::MatrixValue of_block = fde::mittag_leffler(0.5, 1.0, block);
  const auto [slope, bound_of_slope] = fde::mittag_leffler_derivative(1, 0.5, 1.0, -one);
  std::printf("%.15f = %.15f\n", of_block.value(0, 1).real(), slope.real());
}
