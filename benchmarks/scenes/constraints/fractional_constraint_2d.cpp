// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "fdebench/benchmarks/scenes/with_reference.hpp"
#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t multiplier_component = 6;

// The multiplier formulation as a linear system whose orders and coefficients are exactly the parameters, so
// that the reference can use any number of digits: p = q as a row of order alpha gives D^alpha p = w, and e'
// = 0 with e(0) = v(0) gives C0 = a.e if C0 is not given, or (a + b).e at order 1.
reference::LinearSystem system_of(const Parameters& parameters) {
  enum : Eigen::Index { q = 0, v = 2, w = 4, lambda = multiplier_component, p = 7, e = 9, size = 11 };
  const auto pair = [&](std::string_view first, std::string_view second) {
    return std::array{parameters[first], parameters[second]};
  };
  const auto a = pair("a1", "a2"), b = pair("b1", "b2"), k = pair("k1", "k2"), place = pair("q1", "q2"),
             velocity = pair("v1", "v2");
  const auto given = parameters.explicit_value("C0");
  reference::LinearSystem system{.orders = std::vector<double>(size, 1.0),
                                 .initial = std::vector<std::vector<double>>(size),
                                 .matrix = Matrix::Zero(size, size),
                                 .loads = std::vector<std::vector<reference::Load>>(size),
                                 .outputs = {0, 1, 2, 3, 4, 5}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    system.matrix(q + at, v + at) = 1.0;
    system.matrix(v + at, q + at) = -k[i];
    system.matrix(v + at, lambda) = a[i];
    system.matrix(p + at, w + at) = 1.0;
    system.matrix(w + at, w + at) = 1.0;
    system.matrix(w + at, p + at) = 1.0;
    system.matrix(w + at, q + at) = -1.0;
    system.matrix(lambda, v + at) = a[i];
    system.matrix(lambda, w + at) = b[i];
    if (!given) system.matrix(lambda, e + at) = parameters["alpha"] == 1.0 ? -a[i] - b[i] : -a[i];
    system.orders[w + i] = 0.0;
    system.orders[p + i] = parameters["alpha"];
    system.initial[q + i] = {place[i]};
    system.initial[p + i] = {place[i], velocity[i]};
    system.initial[v + i] = system.initial[e + i] = {velocity[i]};
  }
  system.matrix(lambda, lambda) = 1.0;
  system.orders[lambda] = 0.0;
  if (given) system.loads[lambda] = {{-*given}};
  system.loads[v + 1] = {{-parameters["g"]}};
  return system;
}

// C0, or the value of a.v + b.w at t = 0: a.v(0) below order 1, where w(0) = 0, and (a + b).v(0) at order 1,
// where w = v; no other C0 is consistent. Above order 1, w(0) along a supplies the rest, unless a.b = 0.
double constant_of(const Parameters& p) {
  const auto given = p.explicit_value("C0");
  const bool first_order = p["alpha"] == 1.0;
  const auto at_start = [&](const auto& number) {
    auto sum = number("a1") * number("v1") + number("a2") * number("v2");
    if (first_order) sum += number("b1") * number("v1") + number("b2") * number("v2");
    return sum;
  };
  const double known = at_start([&](const char* name) { return p[name]; });
  const auto exact = [&](const char* name) { return reference::shortest_decimal(p[name]); };
  if (!given || reference::shortest_decimal(*given) == reference::Rational(at_start(exact))) return known;
  if (first_order) reject("C0", *given, fmt::format("(a1+b1)*v1+(a2+b2)*v2 = {} for alpha = 1", known));
  if (p["alpha"] < 1.0) reject("C0", *given, fmt::format("a1*v1+a2*v2 = {} for alpha below 1", known));
  if (reference::Rational(exact("a1") * exact("b1") + exact("a2") * exact("b2")) == 0)
    reject("C0", *given, fmt::format("a1*v1+a2*v2 = {} for a.b = 0", known));
  return *given;
}

}  // namespace

SceneFactory fractional_constraint_2d_file();  // of fractional_constraint_2d.toml

SceneFactory fractional_constraint_2d() {
  SceneFactory file = fractional_constraint_2d_file();
  file.make = [file](const Parameters& p) -> Scene {
    Scene scene = file.make(with_value(file, p, "C0", constant_of(p)));
    reference::LinearSystem system = system_of(p);
    scene.reference = reference::linear_reference(system);
    system.outputs = {multiplier_component};
    if (!scene.reactions.depends_on_columns_only())
      scene.reactions.exact = reference::linear_reference(system);
    return scene;
  };
  return file;
}

}  // namespace fde::bench
