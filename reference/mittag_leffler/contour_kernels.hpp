#pragma once

#include <array>
#include <complex>
#include <vector>

#include "laplace/contour.hpp"
#include "numbers/double_double.hpp"

namespace fde {

struct ComplexDoubleDouble {
  DoubleDouble re, im;
};

// The nodes of a contour as arrays, each column filled up with nodes of weight 0 to whole vectors.
struct ContourNodes {
  struct Column {
    std::vector<double> hi, lo;
  };
  Column log_re, log_im, weight_re, weight_im;
  double largest_log = 0.0;  // |Re| + |Im| of log s

  explicit ContourNodes(const Contour<BigReal>& contour);
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
