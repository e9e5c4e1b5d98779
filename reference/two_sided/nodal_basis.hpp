// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fdebench/reference/nonlinear/collocation/panels.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// A time in [0, end] as its distances from both ends, relative to end: they sum to 1. Near an end the
// distance from it keeps its relative accuracy.
struct RelativeTime {
  double from_start, from_end;
  [[nodiscard]] RelativeTime reversed() const { return {from_end, from_start}; }
};

// A basis of functions on [0, 1] given by their values at nodes, of which the first is 0 and the last 1. The
// nodes are symmetric under t -> 1 - t.
struct NodalBasis {
  std::vector<RelativeTime> nodes;
  // rows(order)(t): the weights of the values at the nodes in 1/Gamma(order) int_0^t (t-s)^(order-1) f(s) ds.
  using Row = std::function<Vec(RelativeTime t)>;
  std::function<Row(double order)> rows;
};

// Sinc basis in x with t = 1 / (1 + e^(-pi sinh x)): functions of t that start and end like a small power,
// minus the straight line between their end values, decay doubly exponentially in x and are sums of
// sinc(x/step - j) (F. Stenger, Numerical Methods Based on Sinc and Analytic Functions, 1993; the map: H.
// Takahasi & M. Mori, 1974). Integrals are computed by the trapezoidal rule after the same map.
NodalBasis sinc_nodes(double step);

// t = v^q / (v^q + (1-v)^q) where v(x) is the cubic with v(0) = 0, v(1) = 1 and dt/dx = 2 in the middle: a
// function that starts like t^g, or like (1-t)^g at the end, starts like x^(q g) (R. Kress, Linear Integral
// Equations, 1999, section 12.2).
class ClusteringMap {
 public:
  explicit ClusteringMap(double power) : power_(power), bend_(0.5 - 1.0 / power) {}

  [[nodiscard]] double power() const { return power_; }
  [[nodiscard]] RelativeTime at(RelativeTime x) const;       // t(x)
  [[nodiscard]] RelativeTime inverse(RelativeTime t) const;  // x(t)
  [[nodiscard]] double derivative(RelativeTime x) const;     // dt/dx

 private:
  // v(x) and v'(x); 1 - v(x) = v(1 - x).
  [[nodiscard]] double cubic(double x) const;
  [[nodiscard]] double slope(double x) const;

  double power_, bend_;
};

// Basis of polynomials in x on panels of equal length, through the nodes of `panel` on each.
NodalBasis clustered_panels(const PanelBasis& panel, int panels, const ClusteringMap& time);

}  // namespace fde::reference
