// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/nonlinear/collocation/panel_basis.hpp"
#include "fdebench/reference/two_sided/nodal_basis.hpp"

namespace fde::reference {

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
