#include "mechanical_scene.hpp"

namespace fde {
namespace {

using namespace mechanics;

// u = (k1 q1^2 + k2 q2^2)/2 + g q2; f = a.v + b.w - C0 with C0 = a.v(0), which the motion keeps.
struct LinearConstraint {
  static constexpr int coordinates = 2, constraints = 1;
  static constexpr bool constant = true;
  double order, a1, a2, b1, b2, k1, k2, g, c0;

  template <class S>
  S potential(const Vector<S, 2>& q) const {
    return 0.5 * (k1 * q[0] * q[0] + k2 * q[1] * q[1]) + g * q[1];
  }
  template <class S>
  Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 2>& /*q*/, const Vector<S, 2>& v,
                          const Vector<S, 2>& w) const {
    return Vector<S, 1>(S(a1 * v[0] + a2 * v[1] + b1 * w[0] + b2 * w[1] - c0));
  }
};

}  // namespace

SceneMaker fractional_constraint_2d() {
  static const std::vector<Formulation> fitting{Formulation::integrated, Formulation::acceleration,
                                                Formulation::stabilised, Formulation::multiplier};
  std::vector<Parameter> parameters{{"alpha",
                                     0.5,
                                     {.low = 0.0, .high = 2.0, .open_low = true, .open_high = true},
                                     "order of the constraint"},
                                    {"a1", 1.0, any_number, "weight of q1'"},
                                    {"a2", 2.0, any_number, "weight of q2'"},
                                    {"b1", 0.5, any_number, "weight of D^alpha q1"},
                                    {"b2", -0.3, any_number, "weight of D^alpha q2"},
                                    {"k1", 1.0, any_number, "stiffness of q1"},
                                    {"k2", 2.0, any_number, "stiffness of q2"},
                                    {"g", 0.0, any_number, "force on -q2"},
                                    {"q1", 1.0, any_number, "q1(0)"},
                                    {"q2", 0.0, any_number, "q2(0)"},
                                    {"v1", 0.4, any_number, "q1'(0)"},
                                    {"v2", -0.2, any_number, "q2'(0)"}};
  const auto more = formulation_parameters(fitting);
  parameters.insert(parameters.end(), more.begin(), more.end());
  return {.id = "fractional_constraint_2d",
          .title = "Oscillator in the plane with a linear fractional constraint",
          .source = "Tarasov & Zaslavsky 2006, eqs 41-43, 55-63",
          .parameters = parameters,
          .make = [](const Parameters& p) -> Scene {
            if (p["a1"] == 0.0 && p["a2"] == 0.0) reject("a1", 0.0, "other than 0 where a2 = 0");
            const Setting<LinearConstraint> setting{
                .system = {p["alpha"], p["a1"], p["a2"], p["b1"], p["b2"], p["k1"], p["k2"], p["g"],
                           p["a1"] * p["v1"] + p["a2"] * p["v2"]},
                .start = {{p["q1"], p["q2"]}, {p["v1"], p["v2"]}},
                .coordinates = {"q1", "q2"},
                .end = 10.0,
                .linear = true};
            return mechanical_scene(setting, {formulation_of(p, fitting), p["kappa"]});
          }};
}

}  // namespace fde
