// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "fdebench/reference/special_functions/numbers/real.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

// Legendre's elliptic integral of the first kind and its inverse, Jacobi's amplitude, for a parameter m in
// [0, 1] by the arithmetic-geometric mean (Abramowitz & Stegun 16.4, 17.6). The complement 1 - m is a
// separate argument, as the difference would cancel near m = 1. Every step is free of cancellation.
template <class Real>
class JacobiAmplitude {
 public:
  JacobiAmplitude(const Real& parameter, const Real& complement) {
    using std::sqrt;
    degenerate_ = complement == 0;
    Real a = 1, b = sqrt(complement), c = sqrt(parameter);
    while (!degenerate_) {
      report_progress(scale_.size());
      scale_.push_back({a, b, c});
      if (c <= epsilon<Real>() * a) break;
      const Real mean = (a + b) / 2;
      c = (a - b) / 2;
      b = sqrt(Real(a * b));
      a = mean;
    }
  }

  // F(angle, m) = int_0^angle (1 - m sin^2 s)^(-1/2) ds, for any angle; for m = 1 between -pi/2 and pi/2.
  [[nodiscard]] Real integral(Real angle) const {
    using std::asinh, std::atan2, std::cos, std::floor, std::ldexp, std::sin, std::tan;
    if (degenerate_) return asinh(Real(tan(angle)));
    for (std::size_t n = 0; n + 1 < scale_.size(); ++n) {
      report_progress(n);
      const Real turns = pi<Real>() * floor(Real(angle / pi<Real>() + Real(0.5))), rest = angle - turns;
      angle += turns + atan2(Real(scale_[n].b * sin(rest)), Real(scale_[n].a * cos(rest)));
    }
    return ldexp(Real(angle / scale_.back().a), -last());
  }

  // am(u, m): the angle with F(angle, m) = u.
  [[nodiscard]] Real amplitude(const Real& u) const {
    using std::atan, std::atan2, std::cos, std::ldexp, std::sin, std::sinh, std::sqrt;
    if (degenerate_) return atan(Real(sinh(u)));
    Real angle = ldexp(Real(scale_.back().a * u), last());
    for (auto n = scale_.size() - 1; n > 0; --n) {
      report_progress(n);
      const auto& [a, b, c] = scale_[n];
      const Real across = c * sin(angle), along = c * cos(angle);
      angle = (angle + atan2(across, Real(sqrt(Real(b * b + along * along))))) / 2;
    }
    return angle;
  }

 private:
  struct Means {
    Real a, b, c;
  };
  [[nodiscard]] int last() const { return static_cast<int>(scale_.size()) - 1; }

  std::vector<Means> scale_;
  bool degenerate_ = false;  // m = 1
};

}  // namespace fde::reference
