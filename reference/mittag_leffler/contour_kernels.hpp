#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "laplace/contour.hpp"
#include "numbers/double_double.hpp"

namespace fde {

struct ComplexDoubleDouble {
  DoubleDouble re, im;
};

// The nodes of a contour, all of them moved by `offset`, as arrays, each column filled up with nodes of
// weight 0 to whole vectors.
struct ContourNodes {
  struct Column {
    std::vector<double> hi, lo;
  };
  Column log_re, log_im, weight_re, weight_im;
  double largest_log = 0.0;  // |Re| + |Im| of log s

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

// Sum over nodes and their conjugates of weight times the quotient, times 1 / scale, and what rounding may
// have done to it.
struct QuotientSum {
  ComplexDoubleDouble value;
  double error;
};
QuotientSum sum_over_nodes(const ContourNodes& nodes, const PowerQuotient& quotient);

// s^exponent (1 - q)^-strength in double-double, q = z s^-alpha or, outward, 1 / q in place of q. The power
// is the principal one: its cut runs from each s*^alpha = z to 0, outward to infinity.
struct PowerOfDifference {
  double alpha;
  DoubleDouble exponent;
  double strength;
  ComplexDoubleDouble log_z;
  bool real;  // z is: the lower half is the conjugate of the upper one
  bool outward;
};
QuotientSum sum_over_nodes(const ContourNodes& nodes, const PowerOfDifference& power);

// s^exponent x^j / p(x), x = s^alpha, for every j below the degree of p, which is monic.
struct PolynomialQuotient {
  double alpha;
  DoubleDouble exponent;
  std::span<const ComplexDoubleDouble> coefficients;  // of p from 1 on, but for the leading one
  std::span<const double> errors;                     // of them
};
inline constexpr std::size_t most_degree = 4;
// The errors are infinite where p comes too near to 0 for those of its coefficients.
std::array<QuotientSum, most_degree> sum_over_nodes(const ContourNodes& nodes,
                                                    const PolynomialQuotient& quotient);

// log z on the principal sheet for 1 <= |z| < 4.
ComplexDoubleDouble complex_logarithm(std::complex<double> z);

// The poles s*^alpha = z, log s* = (log z + 2 pi i sheet) / alpha, and the contour they are seen from
// (contour.hpp).
struct PoleArguments {
  double alpha;
  DoubleDouble power;  // 1 - beta
  ComplexDoubleDouble log_z;
  DoubleDouble half_log_mu{};
  double omega = 0.0;  // 0: no contour, the factor is 1
  bool half_step_shift = false;
};

// e^s* s*^(1-beta) / alpha times the factor of the contour = value * 2^exponent, with a relative error.
struct Residue {
  ComplexDoubleDouble value;
  double exponent, relative_error;
};
using Residues = std::array<Residue, double_double_lanes>;
// For so many sheets at a time; those beyond the first count are filled up with copies. |s*| < 2^39.
Residues residues_at(const PoleArguments& poles, const std::array<double, double_double_lanes>& sheets,
                     std::size_t count);

}  // namespace fde
