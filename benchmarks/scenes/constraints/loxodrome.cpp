// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "fdebench/benchmarks/scenes/with_reference.hpp"
#include "fdebench/reference/linear/closed_forms/closed_form.hpp"

namespace fde::bench {
namespace {

double time_to_pole(double theta0, double k, double speed) {
  return (std::numbers::pi - theta0) * std::hypot(1.0, k) / speed;
}

// At constant speed V: theta = theta0 + V t / sqrt(1 + k^2), phi = k ln(tan(theta/2) / tan(theta0/2)). The
// quotient is 1 + sin(delta) / (cos(theta/2) sin(theta0/2)) with delta = (theta - theta0)/2.
struct Loxodrome {
  double theta0, k, speed;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs, std::cos, std::log1p, std::sin, std::sqrt, std::tan;
    const Real start = reference::from_shortest_decimal<Real>(theta0),
               course = reference::from_shortest_decimal<Real>(k);
    const Real rate = reference::from_shortest_decimal<Real>(speed) / sqrt(Real(1 + course * course));
    const Real theta = start + rate * t, delta = rate * t / 2;
    if (theta >= reference::pi<Real>()) {
      throw std::runtime_error(
          fmt::format("the motion ends in the pole at t = {:.6g}", time_to_pole(theta0, k, speed)));
    }
    const Real phi = course * log1p(Real(sin(delta) / (cos(Real(theta / 2)) * sin(Real(start / 2)))));
    // d ln tan(theta/2) = d theta / sin theta: the effect of rounding theta at either end.
    const Real ends = theta / sin(theta) + start / sin(start), turn = abs(course) * rate / sin(theta);
    return {{theta, theta},
            {phi, Real(4 * abs(phi) + abs(course) * ends)},
            {rate, Real(2 * rate)},
            {Real(course * rate / sin(theta)), Real(turn * (3 + abs(Real(theta / tan(theta)))))}};
  }
};

}  // namespace

SceneFactory loxodrome_file();  // of loxodrome.toml

SceneFactory loxodrome() {
  return with_reference(loxodrome_file(), [](const Parameters& p) {
    return reference::closed_form(Loxodrome{p["theta0"], p["k"], p["speed"]});
  });
}

}  // namespace fde::bench
