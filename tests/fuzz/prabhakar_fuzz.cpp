// SPDX-License-Identifier: MIT
// Derivatives of the Mittag-Leffler function, the Prabhakar function and small matrices, for arbitrary
// doubles: finite values with finite bounds, or a one-line error.

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"
#include "fuzz/fuzzing.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

void require_bounded(std::complex<double> value, double bound, const std::string& shown) {
  fuzz::require(std::isfinite(value.real()) && std::isfinite(value.imag()), "a value is finite", shown);
  fuzz::require(bound >= 0.0 && std::isfinite(bound), "a bound is finite and not negative", shown);
}

// Excluded because they take seconds: multiprecision on contours around singularities far from 0 (some
// 100,000 nodes), and the digits that cancel for large beta or gamma or the smallest orders.
constexpr double most_parameter = 20.0, largest_pole = 50.0, least_order = 0.05;

bool is_order(double alpha) { return alpha > 0.0 && alpha <= 5.0; }

double moderate(double parameter) {
  return std::abs(parameter) <= 10000.0 ? std::fmod(parameter, most_parameter) : parameter;
}

std::complex<double> moderate(std::complex<double> z, double alpha) {
  const double most = std::pow(largest_pole, alpha), size = std::abs(z);
  return std::isfinite(size) && size > most ? z * (most / size) : z;
}

double without_tiny_values(double x) { return std::abs(x) < 1e-10 ? 0.0 : x; }

void of_a_number(fuzz::Bytes& bytes, double alpha, double beta, bool derivative) {
  const auto re = bytes.take<double>(), im = bytes.take<double>();
  const auto z = moderate(std::complex(re, im), alpha);
  if (derivative) {
    const int k = bytes.take<std::int8_t>() / 4;
    const auto [value, bound] = reference::mittag_leffler_derivative(k, alpha, beta, z);
    require_bounded(value, bound,
                    fmt::format("derivative {} {} {} {} {}", k, alpha, beta, z.real(), z.imag()));
  } else {
    const double gamma = moderate(bytes.take<double>());
    const auto [value, bound] = reference::prabhakar(alpha, beta, gamma, z);
    require_bounded(value, bound, fmt::format("{} {} {} {} {}", alpha, beta, gamma, z.real(), z.imag()));
  }
}

// Parts of entries near 0 are replaced by 0: multiprecision needs as many additional digits as the sizes of
// entries differ. An eigenvalue is at most the sum of the sizes of all entries.
void of_a_matrix(fuzz::Bytes& bytes, double alpha, double beta, int rows) {
  Eigen::MatrixXcd matrix(rows, rows);
  const bool real = bytes.index_below(2) == 0;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const auto re = bytes.take<double>();
      const auto entry =
          moderate({re, real ? 0.0 : bytes.take<double>()}, alpha) / static_cast<double>(rows * rows);
      matrix(i, j) = {without_tiny_values(entry.real()), without_tiny_values(entry.imag())};
    }
  }
  const auto [values, bounds] = reference::mittag_leffler(alpha, beta, matrix);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j)
      require_bounded(values(i, j), bounds(i, j), fmt::format("entry {} {} of a matrix", i, j));
  }
}

}  // namespace

FDE_FUZZ_TARGET(prabhakar) {
  fuzz::Bytes bytes(data, size);
  const auto kind = bytes.index_below(5);
  const auto order = bytes.take<double>();
  const double alpha = is_order(order) ? std::max(order, least_order) : order,
               beta = moderate(bytes.take<double>());
  fuzz::require_one_line_errors([&] {
    if (kind < 2) {
      of_a_number(bytes, alpha, beta, kind == 0);
    } else {
      of_a_matrix(bytes, alpha, beta, static_cast<int>(kind) - 1);
    }
  });
  return 0;
}
