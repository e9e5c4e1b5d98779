// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"
#include "fdebench/schemes/problem/chain_problem.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

// q1 = x + y, q2 = x - y, u = K(x) y with K = k1 x + k3 x^3, and c (v1 + v2) + b2 D^alpha q2 = C0.
struct PairOfPoints {
  static constexpr int coordinates = 2, constraints = 1;
  static constexpr bool constant = true;
  double order, k1, k3, c, b2, c0;

  template <class S>
  [[nodiscard]] S potential(const Vector<S, 2>& q) const {
    const S x = 0.5 * (q[0] + q[1]), y = 0.5 * (q[0] - q[1]);
    return (k1 + k3 * x * x) * x * y;
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 2>& /*q*/, const Vector<S, 2>& v,
                                        const Vector<S, 2>& w) const {
    return Vector<S, 1>(S(c * (v[0] + v[1]) + b2 * w[1] - c0));
  }
};

// x'' + (2/g) D^(3-alpha) x = -K(x)/2, g = b2/c.
Scene reduced(const Parameters& p) {
  const double k1 = p["k1"], k3 = p["k3"];
  const Chain chain({1.0, 2.0}, {{2.0 * p["c"] / p["b2"], 3.0 - p["alpha"]}}, {p["x0"], p["dx0"]});
  Smoothness smoothness = smoothness_of_chains({chain});
  for (Eigen::Index i = 2; i < chain.size(); ++i) smoothness.unmeasured.push_back(i);
  const auto force = [=](double, In y) { return -0.5 * (k1 + k3 * y[0] * y[0]) * y[0]; };
  const ForceGradient gradient{
      [=](double, In y, double, Out by) { by[0] += -0.5 * (k1 + 3.0 * k3 * y[0] * y[0]); }};
  return {.problem = chain_problem({{.chain = chain, .force = force, .derivatives = gradient}}, 10.0),
          .smoothness = smoothness,
          .outputs = select_components({"x", "dx"}, {0, 1})};
}

// The full system, with the columns x and x'.
Scene pair_of_points(const Parameters& p, Formulation formulation) {
  const double x = p["x0"], y = p["y0"], dx = p["dx0"], dy = p["dy0"];
  const MechanicalSetup<PairOfPoints> setting{
      .system = {p["alpha"], p["k1"], p["k3"], p["c"], p["b2"], p["c"] * ((dx + dy) + (dx - dy))},
      .start = {{x + y, x - y}, {dx + dy, dx - dy}},
      .coordinates = {"q1", "q2"}};
  auto form = pose_formulation(setting, {formulation});
  const auto middle = [columns = form.columns](double t, In state, Out seen) {
    Vec of_points(6);
    columns(t, state, of_points);
    seen << 0.5 * (of_points[0] + of_points[1]), 0.5 * (of_points[2] + of_points[3]);
  };
  const Scene equation = reduced(p);
  for (const RowBlock rows : {form.layout.w, form.layout.lambda})
    exclude_from_measures(form.smoothness, rows);
  return {.problem = std::move(form.problem),
          .ill_posed_reason = std::move(form.ill_posed_reason),
          .smoothness = std::move(form.smoothness),
          .outputs = {equation.outputs.names, middle},
          .reference_problem = PosedProblem{equation.problem, equation.outputs}};
}

}  // namespace

// Three formulations of one motion: equation (66), and two of the system (59), (60) from which it is derived.
// There, y'' = -K(x)/2 acts on x through the constraint x' + (g/2) D^alpha x + (g/4) J^(2-alpha) K = x'(0):
// D^(2-alpha) of this is (66).
SceneFactory nonlinear_fractional_oscillator() {
  return {.id = "nonlinear_fractional_oscillator",
          .title = "Nonlinear oscillator made by a fractional constraint",
          .source = "Tarasov & Zaslavsky 2006, eqs 59-66 (61-66 corrected)",
          .parameters = {choice("form", {"reduced", "integrated", "multiplier"},
                                "equation 66, or forms of 59 and 60"),
                         {"alpha",
                          1.5,
                          {.low = 1.0, .high = 2.0, .open_low = true, .open_high = true},
                          "order of the constraint"},
                         {"k1", 1.0, any_number, "linear stiffness in K"},
                         {"k3", 0.5, any_number, "cubic stiffness in K"},
                         {"c", 1.0, any_number, "weight of q1' + q2' = 2 x'"},
                         {"b2", 0.8, any_number, "weight of D^alpha q2"},
                         {"x0", 0.7, any_number, "x(0)"},
                         {"dx0", 0.3, any_number, "x'(0)"},
                         {"y0", -0.2, any_number, "y(0); not in equation 66"},
                         {"dy0", 0.5, any_number, "y'(0); not in equation 66"}},
          .make = [](const Parameters& p) -> Scene {
            if (p["c"] == 0.0) reject("c", 0.0, "other than 0");
            if (p["b2"] == 0.0) reject("b2", 0.0, "other than 0");
            const std::string& form = p.choice("form");
            return form == "reduced" ? reduced(p) : pair_of_points(p, formulation_named(form));
          },
          .equations = {{.unknown = "x",
                         .terms = {{"1", "2"}, {"2*c/b2", "3 - alpha"}},
                         .rhs = "-(k1*x + k3*x^3)/2",
                         .initial = {"x0", "dx0"}}}};
}

}  // namespace fde::bench
