// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench::mechanics {

Vec columns_at_start(const MechanicalSystem& system) {
  Vec columns = Vec::Zero(static_cast<Eigen::Index>(system.column_count()));
  const auto n = static_cast<Eigen::Index>(system.size());
  columns.head(n) = system.position;
  columns.segment(n, n) = system.velocity;
  for (std::size_t k = 0; k < system.memory.size(); ++k) {
    const auto& [coordinate, order] = system.memory[k];
    if (order == 1.0)
      columns[2 * n + static_cast<Eigen::Index>(k)] = system.velocity[static_cast<Eigen::Index>(coordinate)];
  }
  return columns;
}

Vec values_at(const ExpressionPool& pool, const Expressions& of, double t, In columns) {
  Vec values(std::ssize(of));
  Program(pool, of, columns.size()).evaluate(t, columns, {values.data(), of.size()});
  return values;
}

double zero_if_rounding(double sum, double size) {
  return std::abs(sum) <= 4.0 * std::numeric_limits<double>::epsilon() * size ? 0.0 : sum;
}

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

std::vector<Parameter> choice_of_formulation(const std::vector<Formulation>& fitting) {
  std::vector<std::string> choices;
  for (const auto formulation : fitting) choices.push_back(name_of(formulation));
  std::vector<Parameter> parameters{choice("formulation", choices, "how the constraint enters")};
  if (std::ranges::find(fitting, Formulation::stabilised) != fitting.end())
    parameters.push_back({"kappa", 10.0, not_negative, "rate at which the stabilised form damps the drift"});
  for (auto& parameter : parameters) parameter.keeps_solution = true;
  return parameters;
}

FormulationChoice formulation_choice_of(const Parameters& parameters) {
  const Formulation formulation = formulation_named(parameters.choice("formulation"));
  return {formulation, formulation == Formulation::stabilised ? parameters["kappa"] : 0.0};
}

}  // namespace fde::bench::mechanics
