#pragma once

#include <vector>

#include "problem/chain.hpp"

namespace fde {

// What the Taylor part T of the unknown of a chain does to each of its rows D^v u.
class StartIntegrals {
 public:
  explicit StartIntegrals(const Chain& chain);

  // starts becomes D^v T, and drives sum_k c_k/a I^(L-v) D^(a_k) T, of all rows.
  void at(double t, Out starts, Out drives) const;

 private:
  // starts and drives are sums of these coefficients times t^fraction t^whole, 0 <= fraction < 1: powers of
  // one fraction stand together and share t^fraction.
  struct Power {
    double fraction;
    int whole;
    Vec starts, drives;
  };
  Power& power(double exponent, Eigen::Index rows);

  std::vector<Power> powers_;
};

}  // namespace fde
