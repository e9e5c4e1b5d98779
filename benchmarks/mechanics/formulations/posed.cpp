// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/mechanics/formulations/posed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fde::bench::mechanics {

void exclude_from_measures(Smoothness& smoothness, RowBlock rows) {
  for (int i = 0; i < rows.size; ++i) smoothness.unmeasured.push_back(rows.first + i);
}

// Evaluated at a large y, where the constants of the right-hand side are negligible.
Matrix linear_part_of(const Problem& problem) {
  constexpr double far = 0x1p100;
  const Eigen::Index size = problem.size();
  Vec point = Vec::Zero(size), at_zero(size), f(size);
  Matrix part(size, size);
  problem.rhs(1.0, point, at_zero);
  for (Eigen::Index i = 0; i < size; ++i) {
    point[i] = far;
    problem.rhs(1.0, point, f);
    part.col(i) = (f - at_zero) / far;
    point[i] = 0.0;
  }
  return part;
}

Smoothness linear_start(const Problem& problem, std::vector<PowerLoad> loads) {
  Vec constants(problem.size());
  problem.rhs(0.0, Vec::Zero(problem.size()), constants);
  loads.push_back({0.0, constants});
  Matrix part = std::get<DenseLinearPart>(problem.derivatives)
                    .matrix;  // entries within rounding of 0 are removed below
  for (auto column : part.colwise()) {
    const double rounding = 1e-14 * column.cwiseAbs().maxCoeff();
    column = (column.array().abs() < rounding).select(0.0, column).eval();
  }
  return linear_smoothness(problem.components, part, loads);
}

Smoothness nonlinear_start(const std::vector<Component>& components) {
  std::vector<double> steps{1.0};
  for (const auto& component : components) {
    if (!is_algebraic(component)) steps.push_back(component.order);
  }
  Smoothness smoothness;
  for (const auto& component : components) {
    smoothness.powers.push_back(is_algebraic(component)
                                    ? std::vector<double>{}
                                    : power_lattice({component.order}, steps, component.order + 2.0));
  }
  return smoothness;
}

MechanicalProblem with_multipliers(MechanicalProblem form, const Smoothness& other) {
  form.smoothness = other;
  form.smoothness.powers.resize(form.problem.components.size());
  return form;
}

MechanicalProblem with_multipliers_above_one(MechanicalProblem form, const MechanicalProblem& integrated) {
  const auto &to = form.layout, &from = integrated.layout;
  const auto& known = integrated.smoothness.powers;
  const auto& of_chi = known[from.chi[0]];
  auto& powers = form.smoothness.powers;
  powers.assign(form.problem.components.size(), {});
  for (int i = 0; i < to.q.size; ++i) {
    auto of_v = known[from.z[i]];
    of_v.insert(of_v.end(), of_chi.begin(), of_chi.end());
    powers[to.q[i]] = known[from.q[i]];
    powers[to.v[i]] = power_lattice(of_v, {}, of_v.empty() ? 0.0 : std::ranges::max(of_v));
    powers[to.w[i]] = known[from.w[i]];
  }
  return form;
}

std::vector<double> powers_of_derivative(const std::vector<double>& powers) {
  std::vector<double> lowered;
  for (const double power : powers) {
    if (power > 1.0 && !same_order(power, 1.0)) lowered.push_back(power - 1.0);
  }
  return lowered;
}

std::vector<double> powers_of_memory(const std::vector<std::vector<double>>& powers, RowBlock q,
                                     double order) {
  std::vector<double> all;
  for (int i = 0; i < q.size; ++i) {
    for (const double power : powers[q[i]]) {
      if (power > order && !same_order(power, order)) all.push_back(power - order);
    }
  }
  return all;
}

std::vector<std::string> column_names(const std::vector<std::string>& coordinates, bool memory) {
  std::vector<std::string> names = coordinates;
  const auto add = [&](const std::string& letter, const std::string& prefix) {
    for (const auto& name : coordinates) {
      const bool numbered = name.size() > 1 && name[0] == 'q';
      names.push_back(numbered ? letter + name.substr(1) : prefix + name);
    }
  };
  add("v", "d");
  if (memory) add("w", "Dalpha_");
  return names;
}

MechanicalProblem refused_as_singular(Formulation formulation, double order) {
  return {.ill_posed_reason = fmt::format(
              "formulation = {}: must be neither acceleration nor stabilised for alpha = {}: "
              "v' starts like t^-alpha unless (df/dw) v(0) = 0, which they take for alpha < 1/2 only",
              name_of(formulation), order)};
}

MechanicalProblem refused_above_one(Formulation formulation, double order) {
  return {.ill_posed_reason =
              fmt::format("formulation = {}: must be integrated or multiplier for alpha = {}: above 1 the "
                          "highest derivative is D^(1+alpha) q inside the reaction",
                          name_of(formulation), order)};
}

MechanicalProblem refused_as_unaligned(double order) {
  return {.ill_posed_reason =
              fmt::format("formulation = integrated: must be multiplier for alpha = {} and a.b = 0: above "
                          "1 the constraint then fixes no derivative of order alpha",
                          order)};
}

}  // namespace fde::bench::mechanics
