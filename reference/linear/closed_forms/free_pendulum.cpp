// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/closed_forms/free_pendulum.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

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

// The parameters as numbers of one type.
template <class Real>
struct Motion {
  Real rate2, angle, velocity;
};

// The initial state relative to the stable equilibrium: sin and cos of half the angle, k^2 = (energy)/(2
// rate^2) and 1 - k^2, and the amplification of rounding errors in the latter and in the phase.
template <class Real>
struct Start {
  Real offset, sine, cosine, rate, speed, k2, complement, cancellation;
};

template <class Real>
Start<Real> start_of(const Motion<Real>& motion) {
  using std::abs, std::cos, std::floor, std::sin, std::sqrt;
  const bool upright = motion.rate2 < 0;
  const Real half = motion.angle / 2, from_bottom = upright ? Real(motion.angle - pi<Real>()) : motion.angle;
  const Real turns = floor(Real(from_bottom / (2 * pi<Real>()) + Real(0.5)));
  const Real sine = upright ? Real(-cos(half)) : Real(sin(half));
  const Real cosine = upright ? Real(sin(half)) : Real(cos(half));
  Start<Real> start;
  start.offset = 2 * pi<Real>() * turns + (upright ? pi<Real>() : Real(0));
  start.sine = cosine < 0 ? Real(-sine) : sine;
  start.cosine = abs(cosine);
  start.rate = sqrt(Real(abs(motion.rate2)));
  start.speed = motion.velocity / (2 * start.rate);
  const Real potential = 4 * abs(motion.rate2), moving = motion.velocity * motion.velocity;
  start.k2 = sine * sine + start.speed * start.speed;
  start.complement = (potential * cosine * cosine - moving) / potential;  // an exact 0 is preserved
  const Real terms = cosine * cosine + start.speed * start.speed;
  start.cancellation = start.complement == 0 ? Real(1) : Real(terms / abs(start.complement));
  // The slope of the integral for the initial phase: large for a start almost at rest at the top.
  start.cancellation +=
      start.complement > 0 ? Real(1 / start.cosine) : Real(sqrt(start.k2) / abs(start.speed));
  return start;
}

// Libration: sin(psi/2) = k sn(rate t + u0, k).
template <class Real>
std::pair<Real, Real> libration(const Start<Real>& start, const Real& t) {
  using std::atan2, std::cos, std::sin, std::sqrt;
  const JacobiAmplitude<Real> jacobi(start.k2, start.complement);
  const Real k = sqrt(start.k2);
  const Real first = atan2(start.sine, start.speed);
  const Real angle = jacobi.amplitude(Real(jacobi.integral(first) + start.rate * t));
  const Real up = k * sin(angle), down = k * cos(angle);
  return {Real(2 * atan2(up, Real(sqrt(Real(start.complement + down * down))))), Real(2 * start.rate * down)};
}

// Rotation, in the direction of the velocity: psi/2 = am(k rate t + u0, 1/k).
template <class Real>
std::pair<Real, Real> rotation(const Start<Real>& start, const Real& t) {
  using std::atan2, std::cos, std::sqrt;
  const Real direction = start.speed < 0 ? -1 : 1;
  const Real complement = -start.complement / start.k2;
  const JacobiAmplitude<Real> jacobi(Real(1 / start.k2), complement);
  const Real k = sqrt(start.k2);
  const Real first = atan2(Real(direction * start.sine), start.cosine);
  const Real angle = jacobi.amplitude(Real(jacobi.integral(first) + k * start.rate * t));
  const Real side = cos(angle), slope = sqrt(Real(complement + side * side / start.k2));
  return {Real(2 * direction * angle), Real(2 * direction * k * start.rate * slope)};
}

template <class Real>
std::vector<ConditionedValue<Real>> columns_at(const Motion<Real>& motion, const Real& t) {
  using std::abs;
  const Real& velocity = motion.velocity;
  if (motion.rate2 == 0) {
    const Real way = velocity * t;
    return {{Real(motion.angle + way), Real(abs(motion.angle) + abs(way))}, {velocity, abs(velocity)}};
  }
  const auto start = start_of(motion);
  if (start.k2 == 0) return {{motion.angle, abs(motion.angle)}, {Real(0), Real(0)}};  // stable equilibrium
  const auto [angle, speed] = start.complement <= 0 ? rotation(start, t) : libration(start, t);
  // A relative error of the complement gives a relative error of the period, and so of the phase.
  const Real fastest = abs(velocity) + 2 * start.rate * abs(start.sine);
  const Real phase = (1 + (start.rate + fastest) * t) * (start.cancellation + abs(motion.angle));
  const Real width = std::min(Real(fastest / start.rate), Real(4));
  const Real swing = start.k2 > 1 ? Real(fastest / start.k2) : fastest;
  const Real place = start.offset + angle;
  return {{place, Real(abs(start.offset) + abs(angle) + width * phase)},
          {speed, Real(abs(speed) + swing * phase)}};
}

// In long double and, where the phase would be inaccurate, at more digits.
std::vector<ConditionedValue<long double>> in_long_double(const FreePendulum& p, double t) {
  constexpr long double good = 1e4L;
  constexpr int max_digits = 1000;
  auto columns = columns_at<long double>({p.rate2, p.angle, p.velocity}, t);
  const auto start = start_of<long double>({p.rate2, p.angle, p.velocity});
  const long double lost = start.cancellation + std::abs(static_cast<long double>(p.angle));
  if (p.rate2 == 0.0 || (start.complement != 0 && lost <= good)) return columns;
  for (int digits = 50;; digits *= 2) {
    const Precision precision(digits);
    const auto precise = columns_at<BigReal>({p.rate2, p.angle, p.velocity}, BigReal(t));
    long double worst = 0.0L;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const BigReal size =
          abs(precise[c].value) + precise[c].size * epsilon<BigReal>() / epsilon<long double>();
      columns[c] = {precise[c].value.convert_to<long double>(), size.convert_to<long double>()};
      worst = std::max(worst, columns[c].size / (1.0L + std::abs(columns[c].value)));
    }
    if (worst <= good || digits >= max_digits) return columns;
  }
}

}  // namespace

Reference pendulum_reference(const FreePendulum& p) {
  return closed_form_reference({[p](double t) { return in_long_double(p, t); },
                                [p](double t) {
                                  return columns_at<BigReal>({from_shortest_decimal<BigReal>(p.rate2),
                                                              from_shortest_decimal<BigReal>(p.angle),
                                                              from_shortest_decimal<BigReal>(p.velocity)},
                                                             from_shortest_decimal<BigReal>(t));
                                }});
}

}  // namespace fde::reference
