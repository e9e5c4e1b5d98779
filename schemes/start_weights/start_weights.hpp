#pragma once

#include <memory>
#include <vector>

#include "problem/problem.hpp"
#include "weights/weights.hpp"

namespace fde {

class Moments;

// Start weights of one multistep rule and order: at every step n >= 1 the weights W(n, j) of f_0 ... f_(s-1)
// that make the rule exact where f is one of s powers t^p,
//   sum_{j<s} W(n, j) j^p = e_p(n) = Gamma(p+1)/Gamma(p+g+1) n^(p+g) / kappa - sum_{j<=n} w(n-j) j^p,
// in the units of the weights w, of which that of the newest sample is 1. Source: Lubich 1986, section 4.
//
// The equations are ill-conditioned and their right-hand sides cancel, so both are computed in
// multiprecision, and W(n, j) is right to rounding for every n. docs/schemes.md says how: near steps by the
// sum as it stands, far ones by its asymptotic expansion, which is smooth in n. So far weights are
// polynomials on [K 2^i, K 2^(i+1)].
struct StartWeights {
  // Chebyshev coefficients on one of these intervals, one column a j: of a smooth function of n, and of one
  // that alternates, times (-1)^n; empty: the rule has none.
  struct Piece {
    Matrix smooth, alternating;
  };

  Matrix first;                            // W(n, j) in row n-1, for n up to K
  std::vector<Piece> pieces;               // as many as the steps asked for need
  std::shared_ptr<const Moments> moments;  // from which more pieces are made
};

// The start weights for these powers of f, the first 0 and increasing, for n up to `steps`. Kept for the next
// call with the same rule, order and powers: making them takes milliseconds.
std::shared_ptr<const StartWeights> start_weights(const WeightTable& table, const std::vector<double>& powers,
                                                  int steps);

// How many of these powers, from the first on, have start weights that amplify the rounding of f_0 ...
// f_(s-1) by no more than most_growth, and the largest sum_j |W(n, j)| relative to max(1, n^(g-1)), the size
// of w, over the first steps with so many.
inline constexpr double most_growth = 1e5;
struct UsablePowers {
  std::size_t count;
  double growth;
};
UsablePowers usable_powers(const WeightTable& table, const std::vector<double>& powers);

// Decimal digits of the numbers in which they are made.
inline constexpr int start_weight_digits = 70;

}  // namespace fde
