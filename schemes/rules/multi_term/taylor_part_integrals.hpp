#pragma once

#include <vector>

#include "fdebench/schemes/problem/chain.hpp"

namespace fde {

// Contributions of the Taylor part T of the unknown of a chain to each of its rows D^v u.
class TaylorPartIntegrals {
 public:
  explicit TaylorPartIntegrals(const Chain& chain);

  // Sets starts to D^v T and drives to sum_k c_k/a I^(L-v) D^(a_k) T at t, one entry a row of the chain.
  void at(double t, Out starts, Out drives) const;

 private:
  // starts and drives are sums of these coefficients times t^fraction t^whole, 0 <= fraction < 1. Powers with
  // the same fraction are adjacent and share t^fraction.
  struct Power {
    double fraction;
    int whole;
    Vec starts, drives;
  };
  Power& power(double exponent, Eigen::Index rows);

  std::vector<Power> powers_;
};

}  // namespace fde
