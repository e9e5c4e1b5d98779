// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/two_sided/plane_mechanics.hpp"

#include <cmath>

namespace fde::bench {

TwoSidedStartExponents::TwoSidedStartExponents(double alpha)
    : regular(power_lattice({1.0}, {1.0, 1.0 - alpha}, 3.0)),
      memory(power_lattice({1.0 - alpha}, {1.0, 1.0 - alpha}, 3.0 - alpha)) {}

std::vector<Parameter> prescribed_load_parameters() {
  return {{"T", 1.0, {.low = 0.0, .high = 50.0, .open_low = true}, "the end"},
          {"g1", 0.0, any_number, "constant force on q1"},
          {"g2", 0.0, any_number, "constant force on q2"},
          {"x1", 1.0, any_number, "q1(0)"},
          {"x2", 0.0, any_number, "q2(0)"}};
}

std::vector<Parameter> concatenated(const std::vector<std::vector<Parameter>>& groups) {
  std::vector<Parameter> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

std::vector<Parameter> weight_parameters() {
  return {{"alpha", 0.5, order_below_one, "order of the constraint"},
          {"a1", 1.0, any_number, "weight of q1'"},
          {"a2", 0.5, any_number, "weight of q2'"},
          {"b1", 0.4, any_number, "weight of the left derivative of q1"},
          {"b2", -0.3, any_number, "weight of the left derivative of q2"},
          {"c1", 0.3, any_number, "weight of the right derivative of q1"},
          {"c2", 0.2, any_number, "weight of the right derivative of q2"},
          {"k1", 1.0, any_number, "stiffness of q1"},
          {"k2", 2.0, any_number, "stiffness of q2"}};
}

Parameter motion_choice() {
  return choice("motion", {"made", "given"},
                "a manufactured solution; or the motion that the loads and ends below lead to");
}

bool has_prescribed_loads(const Parameters& p) { return p.choice("motion") == "given"; }

PrescribedLoads::PrescribedLoads(const Parameters& p)
    : end(p["T"]), force(p["g1"], p["g2"]), start(p["x1"], p["x2"]) {}

std::vector<Parameter> drive_parameters() {
  return {{"F0", 0.5, any_number, "F(t) = F0 + F1 cos(omega t) in the constraint"},
          {"F1", 0.2, any_number, "F(t) = F0 + F1 cos(omega t) in the constraint"},
          {"omega", 1.0, any_number, "frequency of F"}};
}

std::function<double(double t)> constraint_drive(const Parameters& p) {
  return [constant = p["F0"], cosine = p["F1"], omega = p["omega"]](double t) {
    return constant + cosine * std::cos(omega * t);
  };
}

}  // namespace fde::bench
