// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/benchmarks/scenes/with_reference.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde::bench {
namespace {

// With r = sqrt(1 + y^2), c = r x' is conserved: x' = c/r, z' = y c/r, and y = y0 + b t. The integrals
//   x = (c/b)(arsinh y - arsinh y0) = (2c/b) artanh(b t / (r + r0)),
//   z = (c/b)(r - r0) = c t (y + y0) / (r + r0)
// are regular at b = 0. For |b t| > (r + r0)/2 the difference of arsinh is better conditioned.
struct ParticleMotion {
  double y0, dx0, dy0;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs, std::asinh, std::sqrt;
    const Real start = reference::from_shortest_decimal<Real>(y0),
               b = reference::from_shortest_decimal<Real>(dy0), y = start + b * t;
    const Real r0 = sqrt(Real(1 + start * start)), r = sqrt(Real(1 + y * y)),
               c = r0 * reference::from_shortest_decimal<Real>(dx0);
    const Real parts = abs(start) + abs(b) * t, sum = r + r0, share = b * t / sum;
    const bool near = abs(share) <= 0.5;
    const Real x = near ? Real(2 * c * t / sum * reference::artanh_quotient(share))
                        : Real(c / b * (asinh(y) - asinh(start)));
    const Real x_size =
        near ? Real(3 * abs(x)) : Real(abs(c / b) * (2 + abs(Real(asinh(y))) + abs(Real(asinh(start)))));
    // d(1/r)/dy = -y/r^3 and d(y/r)/dy = 1/r^3: the effect of rounding y.
    const Real along = abs(c) / r * (3 + parts * abs(y) / (r * r));
    const Real upwards = abs(c) / r * (3 * abs(y) + parts / (r * r));
    return {{x, Real(x_size + abs(c) * t / sum * parts / sum)},
            {y, parts},
            {Real(c * t * (y + start) / sum), Real(3 * abs(c) * t * parts / sum)},
            {Real(c / r), along},
            {b, abs(b)},
            {Real(y * c / r), upwards}};
  }
};

}  // namespace

SceneFactory nonholonomic_particle_file();  // of nonholonomic_particle.toml

SceneFactory nonholonomic_particle() {
  return with_reference(nonholonomic_particle_file(), [](const Parameters& p) {
    return reference::closed_form(ParticleMotion{p["y0"], p["dx0"], p["dy0"]});
  });
}

}  // namespace fde::bench
