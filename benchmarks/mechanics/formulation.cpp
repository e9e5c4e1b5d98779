#include "formulation.hpp"

#include <algorithm>
#include <array>

namespace fde::mechanics {
namespace {

constexpr std::array<std::string_view, 4> names{"integrated", "acceleration", "stabilised", "multiplier"};

}  // namespace

std::vector<Parameter> formulation_parameters(const std::vector<Formulation>& fitting) {
  std::vector<std::string_view> choices;
  for (const auto formulation : fitting) choices.push_back(names.at(static_cast<std::size_t>(formulation)));
  std::vector<Parameter> parameters{choice("formulation", choices, "how the constraint enters")};
  if (std::ranges::find(fitting, Formulation::stabilised) != fitting.end())
    parameters.push_back({"kappa", 10.0, not_negative, "rate at which the stabilised form damps the drift"});
  return parameters;
}

std::vector<Parameter> with_formulations(std::vector<Parameter> parameters,
                                         const std::vector<Formulation>& fitting) {
  const auto more = formulation_parameters(fitting);
  parameters.insert(parameters.end(), more.begin(), more.end());
  return parameters;
}

const std::vector<Formulation>& all_formulations() {
  static const std::vector<Formulation> all{Formulation::integrated, Formulation::acceleration,
                                            Formulation::stabilised, Formulation::multiplier};
  return all;
}

Formulation formulation_of(const Parameters& parameters, const std::vector<Formulation>& fitting) {
  return fitting.at(parameters.choice("formulation"));
}

}  // namespace fde::mechanics
