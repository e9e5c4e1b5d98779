// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The part of starting weights W(n, j) that decays exponentially in n:
//   Re sum_k terms(k, j) n^(power-k) exp(decay n),   Re decay < 0.
struct DecayingWeights {
  ComplexMatrix terms;
  std::complex<double> decay;
  double power;

  // Its values for n = first + 1, ..., one row a step, up to the last that is not negligible, but at most
  // `most`. The number of rows is a multiple of 32.
  [[nodiscard]] Matrix rows(Eigen::Index first, Eigen::Index most) const;
};

}  // namespace fde
