// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/numbers/double_double.hpp"

namespace fde::reference {

struct ComplexDoubleDouble {
  DoubleDouble re, im;
};

// The nodes of a contour, shifted by `offset`, as columns log s and weight (hi and lo parts), each padded
// with nodes of weight 0 to a multiple of double_double_lanes.
struct ContourNodes {
  struct Column {
    std::vector<double> hi, lo;
  };
  Column log_re, log_im, weight_re, weight_im;
  double largest_log = 0.0;  // of |Re| + |Im| of log s

  explicit ContourNodes(const Contour<BigReal>& contour, double offset = 0.0);
  [[nodiscard]] std::size_t size() const { return log_re.hi.size(); }
};

// s^exponent / (s^alpha - z) in double-double; z = scaled / scale with a power of two for scale.
struct PowerQuotient {
  double alpha;
  DoubleDouble exponent;
  std::complex<double> scaled;
  double scale;
};

// Sum over nodes and their conjugates of weight times the quotient, times 1 / scale, and a bound of its
// rounding error.
struct QuotientSum {
  ComplexDoubleDouble value;
  double error;
};
QuotientSum sum_over_nodes(const ContourNodes& nodes, const PowerQuotient& quotient);

// s^exponent (1 - q)^-singularity_order in double-double, q = z s^-alpha, or s^alpha / z if outward. The
// power is the principal one: its cuts run from each s* with s*^alpha = z to 0, or to infinity if outward.
struct BinomialPower {
  double alpha;
  DoubleDouble exponent;
  double singularity_order;
  ComplexDoubleDouble log_z;
  bool real;  // z is real: the lower half of the contour gives the conjugates
  bool outward;
};
QuotientSum sum_over_nodes(const ContourNodes& nodes, const BinomialPower& power);

// s^exponent x^j / p(x), x = s^alpha, for every j below the degree of p, which is monic.
struct PolynomialQuotient {
  double alpha;
  DoubleDouble exponent;
  std::span<const ComplexDoubleDouble> coefficients;  // of p by ascending powers, without the leading 1
  std::span<const double> errors;                     // absolute, of the coefficients
};
inline constexpr std::size_t max_degree = 4;
// The errors are infinite where |p| is too small at a node for the errors of its coefficients.
std::array<QuotientSum, max_degree> sum_over_nodes(const ContourNodes& nodes,
                                                   const PolynomialQuotient& quotient);

// log z on the principal sheet for 1 <= |z| < 4.
ComplexDoubleDouble complex_logarithm(std::complex<double> z);

// The poles s*^alpha = z, log s* = (log z + 2 pi i sheet) / alpha, and the contour that determines their
// factors m (special_functions/laplace/contour.hpp).
struct PoleArguments {
  double alpha;
  DoubleDouble power;  // 1 - beta
  ComplexDoubleDouble log_z;
  DoubleDouble half_log_mu{};
  double omega = 0.0;  // 0: no contour, the factor is 1
  bool half_step_shift = false;
};

// e^s* s*^(1-beta) / alpha times the factor m = value * 2^exponent, with a bound of its relative error.
struct Residue {
  ComplexDoubleDouble value;
  double exponent, relative_error;
};
using Residues = std::array<Residue, double_double_lanes>;
// The residues for the first `count` sheets; the other entries of `sheets` are padding, copies of one of
// them. Precondition: |s*| < 2^39.
Residues residues_at(const PoleArguments& poles, const std::array<double, double_double_lanes>& sheets,
                     std::size_t count);

}  // namespace fde::reference
