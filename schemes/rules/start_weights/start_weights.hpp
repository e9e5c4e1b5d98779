// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "fdebench/schemes/history/weights/family.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

class StartingWeightEquations;

// Starting weights of a fractional linear multistep method of order g: at every step n >= 1 the weights
// W(n, j) of f_0 ... f_(s-1) that make the rule exact for the s functions f = t^p,
//   sum_{j<s} W(n, j) j^p = e_p(n) = Gamma(p+1)/Gamma(p+g+1) n^(p+g) / kappa - sum_{j<=n} w(n-j) j^p,
// scaled like w, so that the newest sample has weight 1. Source: Lubich 1986, section 4.
//
// The equations are ill-conditioned and their right-hand sides cancel, so both are computed in sums of
// several doubles; W(n, j) is accurate to rounding for every n. For n <= K the sum is evaluated directly; for
// larger n its asymptotic expansion, which is smooth in n, is stored as Chebyshev polynomials on [K 2^i, K
// 2^(i+1)], and the part of W(n, j) that decays exponentially beside it. Derivation: docs/schemes.md.
struct StartingWeights {
  // Chebyshev coefficients on one interval, one column a j: W(n, j) = smooth + (-1)^n alternating; the second
  // is empty where the rule has no alternating part. The first rows have W(n, j) - smooth, one row a step,
  // which decays exponentially.
  struct ChebyshevPiece {
    Matrix smooth, alternating, decaying;
  };

  Matrix tabulated;                                          // W(n, j) in row n-1, for n up to K
  std::vector<ChebyshevPiece> pieces;                        // up to the requested number of steps
  std::shared_ptr<const StartingWeightEquations> equations;  // computes further pieces
  double seconds = 0.0;                                      // of a processor, to compute all of this

  // Of what a run with so many steps uses: a longer one may have asked for more.
  [[nodiscard]] std::size_t bytes(int steps) const;
};

// The starting weights for these powers of f and n up to `steps`. Preconditions: table.family->multistep is
// set; powers[0] = 0, powers increase. The result is cached by rule, order and powers, because the
// computation takes longer than many a solve. Thread-safe.
std::shared_ptr<const StartingWeights> starting_weights(const WeightTable& table,
                                                        const std::vector<double>& powers, int steps);

// count: how many of these powers, from the first on, can be used such that the starting weights amplify the
// rounding of f_0 ... f_(s-1) by at most max_growth. growth: this amplification, the maximum over the first
// steps of sum_j |W(n, j)| / max(1, n^(g-1)); the denominator is the size of w.
inline constexpr double max_growth = 1e5;
struct UsablePowers {
  std::size_t count;
  double growth;
};
UsablePowers usable_powers(const WeightTable& table, const std::vector<double>& powers);

// The powers t^r of f(t, y(t)) that a multistep rule with starting weights integrates exactly. The candidates
// are all sums of orders and integers up to rate - 1 (larger powers do not reduce the rate at a fixed time);
// the first ones are used, as many as keep the rounding amplification of every row's starting weights below
// max_growth. They depend on the orders only.
struct StartingPowers {
  std::vector<double> powers;  // the first is 0
  double next;                 // the smallest candidate, of any size, that is not used
  double growth;               // rounding amplification, the maximum over all rows

  // The powers for a run with this number of steps: at most steps + 1.
  [[nodiscard]] std::vector<double> for_steps(int steps) const;
};
StartingPowers starting_powers(const WeightFamily& family, const Problem& problem);

// The same for memory sums with weights of these orders, over samples whose powers are sums of `steps` and
// integers.
StartingPowers starting_powers(const WeightFamily& family, std::vector<double> orders,
                               std::vector<double> steps);

}  // namespace fde
