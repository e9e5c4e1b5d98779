// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/closed_forms/free_pendulum.hpp"

#include <cmath>

#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/closed_forms/jacobi_amplitude.hpp"
#include "fdebench/reference/special_functions/laplace/contour.hpp"

namespace fde::reference {
namespace {

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
