// SPDX-License-Identifier: MIT
#include <acb_calc.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "certificate/enclosure.hpp"

namespace fde::reference::certificate {
namespace {

// With s = e^u, Hankel's integral is E = 1/(2 pi i) int f(u) du,
// f(u) = e^(e^u + (1-beta) u) / (1 - z e^(-alpha u)), from +infinity - i below, along the arc Re u = corner,
// to +infinity + i above. f is meromorphic in the whole plane: there is no cut, and the rays may have any
// angle in (pi/2, 3 pi/2) if the residues e^(s*) s*^(1-beta)/alpha at the poles u* = (log z + 2 pi i k)/alpha
// between them and right of the arc are added.
struct Path {
  double corner, below, above;
};

// Distance from a ray at that angle to the nearest pole.
double clearance(double angle, double alpha, double turn) {
  const double spacing = 2.0 * std::numbers::pi / alpha;
  return std::abs(std::remainder(angle - turn / alpha, spacing));
}

// The angle with the best compromise of fast decay and distance from the poles.
double best_angle(double alpha, double turn) {
  double best = 0.0, best_score = -1.0;
  for (double angle = 1.875; angle <= 4.5; angle += 0.125) {
    const double score = std::min(clearance(angle, alpha, turn), 1.0) * -std::cos(angle);
    if (score > best_score) {
      best = angle;
      best_score = score;
    }
  }
  return best;
}

Path path_for(const Arguments& x) {
  const double alpha = x.alpha.mid().real(), beta = x.beta.mid().real(), turn = std::arg(x.z.mid());
  const double natural = std::log(std::max(1.0, beta)), pole = std::log(std::abs(x.z.mid())) / alpha;
  constexpr double room = 1.0;
  double corner = natural;
  if (std::abs(pole - natural) < room) corner = pole > natural ? pole - room : pole + room;
  // Multiples of 1/8 are exact in double, and symmetric for real z.
  return {std::round(8.0 * corner) / 8.0, best_angle(alpha, -turn), best_angle(alpha, turn)};
}

int integrand(acb_ptr out, const acb_t u, void* parameters, slong /*order*/, slong prec) {
  const WorkingBits bits(prec);
  const auto& x = *static_cast<const Arguments*>(parameters);
  Ball at;
  acb_set(at.get(), u);
  // Where the denominator may be 0 the quotient is not finite, the signal to Arb that f may not be
  // holomorphic.
  Ball value = exp(exp(at) + (Ball(1.0) - x.beta) * at) / (Ball(1.0) - x.z * exp(-x.alpha * at));
  acb_swap(out, value.get());
  return 0;
}

// int f over the segment, with an absolute error goal of 2^tolerance.
Ball integrate(const Arguments& x, const Ball& from, const Ball& to, long tolerance) {
  Ball result;
  mag_t error;
  mag_init(error);
  mag_set_ui_2exp_si(error, 1, tolerance);
  Arguments copy = x;
  acb_calc_integrate(result.get(), integrand, &copy, from.get(), to.get(), WorkingBits::get(), error, nullptr,
                     WorkingBits::get());
  mag_clear(error);
  return result;
}

// The t at which e^(cos(angle) e^t) has decayed by `bits` bits relative to the corner.
double end_of(double angle, double corner, double beta, double bits) {
  const double fall = -std::cos(angle);
  double radius = std::max(std::exp(corner), 1.0);
  const double needed = bits * std::numbers::ln2 + std::exp(corner);
  for (int i = 0; i < 50; ++i) {
    radius = std::max(radius, (needed + std::max(0.0, -beta) * std::log(radius) + 2.0) / fall);
  }
  return std::ceil(8.0 * std::log(radius)) / 8.0;
}

// Bound of int_end^infinity |f(t + i angle)| dt. With X = e^end and c = -cos(angle),
// int_X^infinity e^(-c x) x^-beta dx <= e^(-c X) X^-beta / (c - max(0, -beta)/X), and 1 - z e^(-alpha u) is
// on a ray from 1 with the fixed direction psi, so its modulus is at least |sin psi|, or 1 where cos psi < 0.
Ball tail(const Arguments& x, double angle, double end) {
  const Ball radius = exp(Ball(end)), c = -cos(Ball(angle)), psi = arg(x.z) - x.alpha * Ball(angle);
  const Ball rate = x.beta < Ball(0.0) ? c + x.beta / radius : c;
  if (!(rate > Ball(0.0))) throw std::runtime_error("the ray ends too early");
  const Ball denominator = cos(psi) < Ball(0.0) ? Ball(1.0) : abs(sin(psi));
  return exp(-c * radius - x.beta * Ball(end)) / (rate * denominator);
}

// The integral from the corner outwards along the ray at that angle.
Ball ray(const Arguments& x, double corner, double angle, long tolerance) {
  const double end =
      end_of(std::abs(angle), corner, x.beta.mid().real(), static_cast<double>(WorkingBits::get()));
  const Ball height = Ball::i() * Ball(angle);
  Ball sum = integrate(x, Ball(corner) + height, Ball(end) + height, tolerance);
  sum.widen(tail(x, angle, end));
  return sum;
}

Ball residues(const Arguments& x, const Path& path) {
  Ball sum;
  const Ball log_z = log(x.z);
  if (real(log_z) / x.alpha < Ball(path.corner)) return sum;
  if (!(real(log_z) / x.alpha > Ball(path.corner))) throw std::runtime_error("a pole is on the arc");
  const int most = static_cast<int>(x.alpha.mid().real()) + 2;
  for (int k = -most; k <= most; ++k) {
    const Ball u = (log_z + Ball::i() * Ball::pi() * Ball(2.0 * k)) / x.alpha;
    if (imag(u) > Ball(path.above) || imag(u) < Ball(-path.below)) continue;
    if (!(imag(u) < Ball(path.above) && imag(u) > Ball(-path.below)))
      throw std::runtime_error("a pole is on a ray");
    sum = sum + exp(exp(u) + (Ball(1.0) - x.beta) * u) / x.alpha;
  }
  return sum;
}

// log2 |f| where the arc crosses the real axis.
double size_at(const Arguments& x, double corner) {
  const double alpha = x.alpha.mid().real(), size = std::abs(x.z.mid());
  const double log_size = std::exp(corner) + (1.0 - x.beta.mid().real()) * corner;
  return log_size / std::numbers::ln2 - std::log2(1.0 + size * std::exp(-alpha * corner));
}

}  // namespace

Ball hankel_integral(const Arguments& x) {
  const Path path = path_for(x);
  const long tolerance = std::lround(size_at(x, path.corner)) - WorkingBits::get();
  const Ball above = Ball(path.corner) + Ball::i() * Ball(path.above);
  const Ball upper = ray(x, path.corner, path.above, tolerance);
  if (x.real()) {  // the lower half is the conjugate of the upper one
    const Ball half = integrate(x, Ball(path.corner), above, tolerance) + upper;
    return imag(half) / Ball::pi() + real(residues(x, path));
  }
  const Ball below = Ball(path.corner) - Ball::i() * Ball(path.below);
  const Ball lower = ray(x, path.corner, -path.below, tolerance);
  const Ball whole = integrate(x, below, above, tolerance) + upper - lower;
  return whole / (Ball(2.0) * Ball::i() * Ball::pi()) + residues(x, path);
}

}  // namespace fde::reference::certificate
