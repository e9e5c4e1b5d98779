// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/chain.hpp"

namespace fde {

// Contributions of the Taylor part T of the unknown of a chain to each of its rows D^v u.
class TaylorPartIntegrals {
 public:
  explicit TaylorPartIntegrals(const Chain& chain);

  // Sets derivatives to D^v T and integrals to sum_k c_k/a I^(L-v) D^(a_k) T at t, one entry a row of the
  // chain.
  void at(double t, Out derivatives, Out integrals) const;

 private:
  // derivatives and integrals are sums of these coefficients times t^fraction t^whole, 0 <= fraction < 1.
  // Powers with the same fraction are adjacent and share t^fraction.
  struct Power {
    double fraction;
    int whole;
    Vec derivatives, integrals;
  };
  Power& power(double exponent, Eigen::Index rows);

  std::vector<Power> powers_;
};

}  // namespace fde
