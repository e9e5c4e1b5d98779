// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/mechanical_scene.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

// Two unit masses between two walls, three equal springs: u = k (q1^2 + (q2 - q1)^2 + q2^2)/2, and f =
// |v|^2/2 + coupling v.w - K. With d = v + coupling w = df/dv the constraint is |d|^2 = 2K + coupling^2
// |w|^2: d never vanishes, so the multiplier is always determined.
struct ChainWithMemory {
  static constexpr int coordinates = 2, constraints = 1;
  double order, coupling, k, kinetic;

  template <class S>
  [[nodiscard]] S potential(const Vector<S, 2>& q) const {
    const S stretched = q[1] - q[0];
    return 0.5 * k * (q[0] * q[0] + stretched * stretched + q[1] * q[1]);
  }
  template <class S>
  [[nodiscard]] Vector<S, 1> constraint(const S& /*t*/, const Vector<S, 2>& /*q*/, const Vector<S, 2>& v,
                                        const Vector<S, 2>& w) const {
    return Vector<S, 1>(
        S(0.5 * (v[0] * v[0] + v[1] * v[1]) + coupling * (v[0] * w[0] + v[1] * w[1]) - kinetic));
  }
};

}  // namespace

// K = |v(0)|^2/2, because w(0) = 0: a Gaussian thermostat with memory.
SceneFactory fractional_constraint_nonlinear() {
  const std::vector<Parameter> parameters{{"alpha", 0.4, order_below_one, "order of the constraint"},
                                          {"coupling", 0.3, any_number, "weight of v.D^alpha q"},
                                          {"k", 1.0, any_number, "stiffness of the springs"},
                                          {"q1", 1.0, any_number, "q1(0)"},
                                          {"q2", 0.0, any_number, "q2(0)"},
                                          {"v1", 0.6, any_number, "q1'(0)"},
                                          {"v2", 0.8, any_number, "q2'(0)"}};
  return {.id = "fractional_constraint_nonlinear",
          .title = "Chain of oscillators with a constraint quadratic in velocities and memory",
          .source = "Tarasov & Zaslavsky 2006, eqs 29, 32, 36, 37",
          .parameters = with_formulations(parameters, unprojected_formulations()),
          .make = [](const Parameters& p) -> Scene {
            if (p["v1"] == 0.0 && p["v2"] == 0.0) reject("v1", 0.0, "other than 0 where v2 = 0");
            const MechanicalSetup<ChainWithMemory> setting{
                .system = {p["alpha"], p["coupling"], p["k"], 0.5 * (p["v1"] * p["v1"] + p["v2"] * p["v2"])},
                .start = {{p["q1"], p["q2"]}, {p["v1"], p["v2"]}},
                .coordinates = {"q1", "q2"},
                .end = 10.0,
                .reference = p["alpha"] < 0.5 ? Formulation::acceleration : Formulation::multiplier};
            return mechanical_scene(setting, formulation_choice_of(p));
          },
          .equations = {{.unknown = "q1",
                         .terms = {{"1", "2"}},
                         .rhs = "-k*(2*q1 - q2) + lambda*(D(q1,1) + coupling*D(q1,alpha))",
                         .initial = {"q1", "v1"}},
                        {.unknown = "q2",
                         .terms = {{"1", "2"}},
                         .rhs = "-k*(2*q2 - q1) + lambda*(D(q2,1) + coupling*D(q2,alpha))",
                         .initial = {"q2", "v2"}},
                        {.unknown = "lambda",
                         .terms = {{"1", "0"}},
                         .rhs = "(D(q1,1)^2 + D(q2,1)^2)/2 + coupling*(D(q1,1)*D(q1,alpha) + "
                                "D(q2,1)*D(q2,alpha)) - (v1^2 + v2^2)/2",
                         .initial = {"0"}}}};
}

}  // namespace fde::bench
