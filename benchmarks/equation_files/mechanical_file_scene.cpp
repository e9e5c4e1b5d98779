// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"
#include "fdebench/benchmarks/equation_files/mechanical_file.hpp"
#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_scene.hpp"
#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {
namespace {

using mechanics::Algebra;
using mechanics::Dynamics;
using mechanics::MechanicalSystem;

// The orders of the rows of the multiplier form without rounding, as differences of two decimals.
std::pair<double, double> order_of(const mechanics::StateRow& row, const Component& component) {
  switch (row.kind) {
    case mechanics::RowKind::memory:
      return {row.order, row.order < 1.0 ? 1.0 : 2.0};
    case mechanics::RowKind::multiplier:
      return {0.0, 0.0};
    case mechanics::RowKind::velocity:
      if (row.order > 1.0) return {1.0, row.order};
      [[fallthrough]];
    default:
      return {0.0, component.order};
  }
}

// The exact solution of a linear system, from its multiplier form, whose coefficients are those of the file.
void add_linear_reference(Scene& scene, const MechanicalFile& file, FileFormulas& formulas) {
  const auto posed = [](const Dynamics& dynamics) {
    return mechanics::posed(dynamics, {dynamics.has_constraints() ? mechanics::Formulation::multiplier
                                                                  : mechanics::Formulation::acceleration});
  };
  const auto is_linear_motion = [&](ExpressionPool& pool) {
    const Algebra algebra(pool);
    const auto equations = posed(Dynamics(file.system, algebra));
    return is_linear(expression_problem(equations.components, equations.rhs, 1.0, pool));
  };
  if (!is_linear_motion(formulas.pool())) return;
  FileFormulas exact(formulas.text(), formulas.parameters(), NumberStorage::fractions);
  auto system = read_mechanical_file(exact).system;
  system.velocity = file.system.velocity;  // which may have been projected onto the constraints
  auto& pool = exact.pool();
  const Algebra algebra(pool);
  const Dynamics dynamics(system, algebra);
  const auto equations = posed(dynamics);
  LinearRows rows{
      .components = equations.components, .rows = equations.rhs, .initial = equations.exact_initial};
  std::vector<std::size_t> multipliers;
  for (std::size_t i = 0; i < equations.rows.size(); ++i) {
    rows.orders.push_back(order_of(equations.rows[i], equations.components[i]));
    if (equations.rows[i].kind == mechanics::RowKind::multiplier) multipliers.push_back(i);
  }
  for (std::size_t c = 0; c < scene.outputs.names.size(); ++c)
    rows.outputs.push_back(static_cast<std::size_t>(pool[equations.columns[c]].variable - 1));
  auto reference = linear_rows_reference(rows, pool);
  if (!reference) return;
  scene.reference = std::move(*reference);
  if (scene.reactions.has_exact_multipliers() || !scene.reactions) return;
  // Above order 1 the multiplier of this form lacks a part if lambda is unbounded at the start.
  if (*dynamics.constraint_orders().rbegin() > 1.0 && !scene.reactions.initial_multipliers) return;
  rows.outputs = multipliers;
  if (auto lambda = linear_rows_reference(rows, pool)) scene.reactions.exact = std::move(*lambda);
}

// The formulation of the reference at the default parameters; `other` if the motion does not start regularly
// then.
mechanics::Formulation best_formulation(const EquationText& text, const Parameters& defaults,
                                        mechanics::Formulation other) {
  FileFormulas formulas(text, defaults, NumberStorage::values);
  const auto system = read_mechanical_file(formulas).system;
  const Algebra algebra(formulas.pool());
  try {
    return mechanics::reference_formulation(Dynamics(system, algebra));
  } catch (const std::invalid_argument&) {
    return other;
  }
}

// Throws std::invalid_argument if two columns have one name, or one has that of a column that commands add.
void require_distinct(const std::vector<SystemColumn>& columns, const FileFormulas& formulas) {
  constexpr std::array<std::string_view, 8> added{"t",     "energy", "constraint", "bound",
                                                  "power", "lambda", "solution",   "event"};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto& name = columns[c].name;
    const bool is_multiplier =
        name.starts_with("lambda") && name.find_first_not_of("0123456789", 6) == std::string::npos;
    const bool is_repeated = std::any_of(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(c),
                                         [&](const SystemColumn& one) { return one.name == name; });
    if (is_repeated || is_multiplier || std::ranges::find(added, name) != added.end()) {
      reject_at(formulas.text().file, formulas.text().unknowns[columns[c].unknown].position,
                fmt::format("column {}: must have another name, a column has this one", name));
    }
  }
}

constexpr std::string_view velocity_name = "initial_velocity";

// The parameter initial_velocity: whether the velocities are projected onto the constraints. A file may have
// a parameter of its own with this name, which takes its place.
bool has_velocity_parameter(const MechanicalFile& file, const EquationText& text) {
  return !text.is_built_in && file.starts_with_velocities && !text.mechanics->constraints.empty() &&
         std::ranges::none_of(text.parameters,
                              [](const auto& one) { return one.declared.name == velocity_name; });
}

Parameter velocity_parameter(const EquationText& text) {
  std::vector<std::string> words{"given", "projected"};
  if (text.mechanics->projects_velocity) std::ranges::reverse(words);
  return choice(std::string(velocity_name), words,
                "initial velocities as given, or projected onto the constraints");
}

// Moves v(0) onto the constraints; a line with the change of each velocity.
std::string project_velocity(MechanicalSystem& system, ExpressionPool& pool) {
  const Algebra algebra(pool);
  const Dynamics dynamics(system, algebra);
  const Vec projected = mechanics::projected_velocity(dynamics), change = projected - system.velocity;
  system.velocity = projected;
  std::vector<std::string> changes;
  for (std::size_t i = 0; i < system.size(); ++i) {
    changes.push_back(
        fmt::format("D({},1) by {:.3g}", system.coordinates[i], change[static_cast<Eigen::Index>(i)]));
  }
  return fmt::format("initial velocities projected onto the constraints: {}", fmt::join(changes, ", "));
}

}  // namespace

Scene mechanical_file_scene(MechanicalFile file, FileFormulas& formulas, const Parameters& parameters,
                            const std::function<void(const std::string& note)>& on_note) {
  auto& pool = formulas.pool();
  auto& system = file.system;
  std::vector<std::string> names;
  const auto columns = columns_of(file);
  require_distinct(columns, formulas);
  for (const auto& column : columns) names.push_back(column.name);
  const double end = formulas.end();
  return with_positions(formulas, [&] {
    const auto scene_of_motion = [&] {
      if (file.is_extremum) return mechanics::extremum_scene(system, file.ends, names, end, pool);
      const auto choice = system.constraints.empty()
                              ? mechanics::FormulationChoice{mechanics::Formulation::acceleration}
                              : mechanics::formulation_choice_of(parameters);
      Scene scene = mechanics::mechanical_scene(system, choice, names, end, pool);
      if (scene.ill_posed_reason.empty()) add_linear_reference(scene, file, formulas);
      return scene;
    };
    try {
      return scene_of_motion();
    } catch (const mechanics::StartError& fault) {
      if (!has_velocity_parameter(file, formulas.text())) throw;
      if (parameters.choice(velocity_name) != "projected") {
        throw mechanics::ConstraintError(
            fault.constraint, fmt::format("{}; --set {}=projected takes it", fault.what(), velocity_name));
      }
    }
    const auto note = project_velocity(system, pool);
    if (on_note) on_note(fmt::format("{}: {}", formulas.text().file, note));
    return scene_of_motion();
  });
}

std::vector<Parameter> formulation_parameters(const EquationText& text) {
  if (text.mechanics->constraints.empty()) return {};
  const auto defaults = default_parameters(text);
  FileFormulas formulas(text, defaults, NumberStorage::values, FileFormulas::ParametersAs::variables);
  const auto file = read_mechanical_file(formulas);
  std::vector<Parameter> added;
  if (has_velocity_parameter(file, text)) added.push_back(velocity_parameter(text));
  if (text.mechanics->is_vakonomic) return added;
  const auto& system = file.system;
  auto fitting =
      with_positions(formulas, [&] { return mechanics::formulations_of(system, formulas.pool()); });
  const auto& given = text.mechanics->formulation;
  const auto chosen = given.empty() ? name_of(best_formulation(text, defaults, fitting.front())) : given;
  const auto first = std::ranges::find(fitting, chosen, mechanics::name_of);
  if (first == fitting.end()) {
    formulas.reject(
        text.mechanics->constraints.front(),
        fmt::format("formulation = {}: must not be {}, this constraint is not affine in the velocity", chosen,
                    chosen));
  }
  std::rotate(fitting.begin(), first, first + 1);
  auto all = mechanics::choice_of_formulation(fitting);
  all.insert(all.end(), added.begin(), added.end());
  return all;
}

Parameters default_parameters(const EquationText& text) {
  std::vector<Parameter> declared;
  for (const auto& parameter : text.parameters) declared.push_back(parameter.declared);
  return {text.file, declared, {}};
}

}  // namespace fde::bench
