#pragma once

#include <cstdint>
#include <optional>

namespace fde {

// Weights of the past on a uniform grid, good to a few units in the last place at every lag and order in (0,
// 2]. As usually printed they are differences of nearly equal powers and lose up to k^2 units; these are not.
// Every scheme sums w(n-j) x_j over 1 <= j < n, a lag k = n - j at least 1, and gives x_0 a start weight.

enum class WeightFamily {
  rectangle,  // k^g - (k-1)^g: product rectangle rule, Adams-Bashforth predictor
  trapezoid,  // (k+1)^(g+1) - 2 k^(g+1) + (k-1)^(g+1): product trapezoidal rule, Adams-Moulton corrector
  grunwald_letnikov,  // (-1)^k binomial(-g, k) = Gamma(k+g) / (Gamma(g) k!): backward Euler convolution
                      // quadrature
  l1,                 // (k+1)^(1-g) - k^(1-g): L1 rule on the increments of y, g <= 1
};

// One weight table: a family and the order g of the equation it serves. Order 0, that of an algebraic row,
// has no weights, and step_factor 1 for every length.
struct WeightTable {
  WeightFamily family;
  double order;
  bool operator==(const WeightTable&) const = default;
};

// w(lag) of a table, lag >= 1.
double weight(const WeightTable& table, std::int64_t lag);

// w(lag) - w(lag - 1), with 0 in place of w(0). Taken from weights in extended precision, so it is off by
// rounding of w(lag) there, about 1/2000 unit of a double: small in every sum in which it stands for w.
double weight_increment(const WeightTable& table, std::int64_t lag);

// The value that w(k) has for every k, when there is one: order 1 has no memory, a running sum replaces the
// history.
std::optional<double> constant_weight(const WeightTable& table);

// Weight of x_0 at step n >= 1 where it is not w(n): the trapezoidal rule has (n-1)^(g+1) - (n-1-g) n^g (Yin,
// Liu & Anh 2007, eq. 3.7, first line), Grunwald-Letnikov and L1 have 0. nullopt: the rule is the plain
// convolution.
std::optional<double> start_weight(const WeightTable& table, std::int64_t n);

// kappa in y_n = past + kappa f(t_n, y_n) for a step of this length: h^g/Gamma(g+1) for the rectangle,
// h^g/Gamma(g+2) for the trapezoid, h^g for Grunwald-Letnikov, Gamma(2-g) h^g for L1.
double step_factor(const WeightTable& table, double length);

}  // namespace fde
