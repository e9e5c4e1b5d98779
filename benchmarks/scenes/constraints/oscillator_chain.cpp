// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/constraints/oscillator_chain.hpp"

namespace fde::bench {

std::vector<Parameter> chain_parameters(const std::vector<Parameter>& own) {
  std::vector<Parameter> parameters{{"k", 1.0, not_negative, "stiffness of the springs"},
                                    {"c", 0.5, not_negative, "stiffness that grows with the square"},
                                    {"q1", 0.5, any_number, "q1(0)"},
                                    {"q2", 0.0, any_number, "q2(0)"},
                                    {"q3", -0.3, any_number, "q3(0)"},
                                    {"v1", 0.6, any_number, "q1'(0)"},
                                    {"v2", -0.4, any_number, "q2'(0)"},
                                    {"v3", 0.3, any_number, "q3'(0)"}};
  parameters.insert(parameters.end(), own.begin(), own.end());
  return parameters;
}

mechanics::InitialState<3> chain_start(const Parameters& p) {
  mechanics::InitialState<3> start{{p["q1"], p["q2"], p["q3"]}, {p["v1"], p["v2"], p["v3"]}};
  if (start.v.isZero(0.0)) reject("v1", 0.0, "other than 0 where v2 = 0 and v3 = 0: nothing would move");
  return start;
}

}  // namespace fde::bench
