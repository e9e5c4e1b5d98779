// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulation.hpp"

#include <algorithm>
#include <array>

namespace fde::bench::mechanics {

std::string name_of(Formulation formulation) {
  constexpr std::array<const char*, 4> names{"integrated", "acceleration", "stabilised", "multiplier"};
  return names.at(static_cast<std::size_t>(formulation));
}

Formulation formulation_named(std::string_view name) {
  const auto found = std::ranges::find(all_formulations(), name, name_of);
  if (found == all_formulations().end()) reject("formulation", std::string(name), "a formulation");
  return *found;
}

const std::vector<Formulation>& all_formulations() {
  static const std::vector<Formulation> all{Formulation::integrated, Formulation::acceleration,
                                            Formulation::stabilised, Formulation::multiplier};
  return all;
}

const std::vector<Formulation>& unprojected_formulations() {
  static const std::vector<Formulation> all{Formulation::acceleration, Formulation::stabilised,
                                            Formulation::multiplier};
  return all;
}

std::vector<Parameter> with_formulations(std::vector<Parameter> parameters,
                                         const std::vector<Formulation>& fitting) {
  std::vector<std::string> choices;
  for (const auto formulation : fitting) choices.push_back(name_of(formulation));
  parameters.push_back(choice("formulation", choices, "how the constraint enters"));
  if (std::ranges::find(fitting, Formulation::stabilised) != fitting.end())
    parameters.push_back({"kappa", 10.0, not_negative, "rate at which the stabilised form damps the drift"});
  return parameters;
}

FormulationChoice formulation_choice_of(const Parameters& parameters) {
  const Formulation formulation = formulation_named(parameters.choice("formulation"));
  return {formulation, formulation == Formulation::stabilised ? parameters["kappa"] : 0.0};
}

}  // namespace fde::bench::mechanics
