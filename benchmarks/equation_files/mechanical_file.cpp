// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/mechanical_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"
#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/mechanics/extremum_scene.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_scene.hpp"
#include "fdebench/benchmarks/mechanics/memory_extremum.hpp"
#include "fdebench/benchmarks/mechanics/motion_start.hpp"
#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {
namespace {

using mechanics::Algebra;
using mechanics::Dynamics;
using mechanics::MechanicalSystem;
using mechanics::MemoryTerm;

constexpr Range memory_orders{.low = 0.0, .high = 2.0, .open_low = true, .open_high = true};

bool same_term(const MemoryTerm& a, const MemoryTerm& b) {
  return a.coordinate == b.coordinate && same_order(a.order, b.order);
}

// Maps D(x, order) to variables of the columns of a system.
class ColumnVariables {
 public:
  ColumnVariables(MechanicalSystem& system, ExpressionPool& pool) : system_(system), pool_(pool) {}

  // With `collect`, memory terms that are new are added; otherwise all are known. `limit`: whether an order
  // that is a formula with the value 1 is the limit of lower orders, not the velocity.
  [[nodiscard]] FormulaVariables all(bool collect, bool limit) {
    return {.time = true,
            .resolve_unknown = [=, this](std::size_t i,
                                         double order) { return variable(i, order, true, collect); },
            .resolve_formula_order = [=, this](std::size_t i,
                                               double order) { return variable(i, order, !limit, collect); }};
  }

 private:
  Expression variable(std::size_t i, double order, bool is_velocity_at_one, bool collect) {
    if (order == 0.0) return pool_.variable(system_.q()[i]);
    if (order == 1.0 && is_velocity_at_one) return pool_.variable(system_.v()[i]);
    if (!memory_orders.contains(order)) {
      throw std::invalid_argument(fmt::format("D({}, {}): its order must be {}", system_.coordinates[i],
                                              order, memory_orders.text()));
    }
    auto& memory = system_.memory;
    const auto found = std::ranges::find_if(memory, [&](const auto& term) {
      return same_term(term, {i, order});
    });
    const auto place = static_cast<std::size_t>(found - memory.begin());
    if (found == memory.end() && collect) memory.push_back({i, order});
    return pool_.variable(static_cast<int>(2 * system_.size() + place) + 1);
  }

  MechanicalSystem& system_;
  ExpressionPool& pool_;
};

void read_forces(MechanicalSystem& system, FileFormulas& formulas, const FormulaVariables& variables) {
  system.forces.assign(system.size(), formulas.pool().number(0));
  for (const auto& force : formulas.text().mechanics->forces) {
    const auto coordinate = std::ranges::find(system.coordinates, force.name);
    system.forces[static_cast<std::size_t>(coordinate - system.coordinates.begin())] =
        formulas.read(force.formula, variables);
  }
}

void read_constraints(MechanicalSystem& system, FileFormulas& formulas, const FormulaVariables& variables) {
  system.constraints.clear();
  for (const auto& constraint : formulas.text().mechanics->constraints) {
    system.constraints.push_back(formulas.read(constraint, variables));
    if (!formulas.pool().arguments({system.constraints.back()}, {Operation::sign, Operation::step}).empty()) {
      formulas.reject(constraint,
                      "has a sign or a step: must be continuous, for the velocity would jump with it");
    }
  }
}

// q(0), and v(0) unless the ends are given.
void read_start(MechanicalSystem& system, FileFormulas& formulas, bool has_velocities) {
  const auto& coordinates = formulas.text().unknowns;
  system.position = system.velocity = Vec::Zero(std::ssize(coordinates));
  const std::size_t needed = has_velocities ? 2 : 1;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const auto& coordinate = coordinates[i];
    const auto at = static_cast<Eigen::Index>(i);
    if (coordinate.initial.size() != needed) {
      reject_at(formulas.text().file, coordinate.position,
                fmt::format("coordinate {}: has {} initial value{}: must have {}", coordinate.name,
                            coordinate.initial.size(), coordinate.initial.size() == 1 ? "" : "s",
                            has_velocities
                                ? "2, its place and its velocity"
                                : "1, its place, in an extremum with values at the end or D(x, a) in L"));
    }
    system.position[at] = formulas.constant(coordinate.initial[0], "initial", any_number);
    if (has_velocities) system.velocity[at] = formulas.constant(coordinate.initial[1], "initial", any_number);
  }
}

mechanics::ExtremumEnds read_ends(const MechanicalSystem& system, FileFormulas& formulas) {
  const auto& text = formulas.text();
  mechanics::ExtremumEnds ends{.multipliers = Vec::Zero(std::ssize(system.constraints))};
  for (const auto& coordinate : text.unknowns) {
    auto& last = ends.final.emplace_back();
    if (coordinate.final.size() > 1) {
      reject_at(text.file, coordinate.position,
                fmt::format("coordinate {}: has {} final values: must have 1, its place at the end",
                            coordinate.name, coordinate.final.size()));
    }
    if (!coordinate.final.empty()) last = formulas.constant(coordinate.final[0], "final", any_number);
  }
  const auto& multipliers = text.mechanics->multipliers;
  if (!multipliers.empty() && multipliers.size() != system.constraints.size()) {
    formulas.reject(multipliers.front(), fmt::format("there are {} multipliers: must be {}, one a constraint",
                                                     multipliers.size(), system.constraints.size()));
  }
  for (std::size_t j = 0; j < multipliers.size(); ++j) {
    ends.multipliers[static_cast<Eigen::Index>(j)] =
        formulas.constant(multipliers[j], "multipliers", any_number);
  }
  return ends;
}

// The names that [columns] gives to coordinates and their derivatives.
std::map<int, std::string> read_column_names(FileFormulas& formulas, const FormulaVariables& variables) {
  std::map<int, std::string> names;
  for (const auto& column : formulas.text().columns) {
    const auto value = formulas.read(column.formula, variables);
    const auto& entry = formulas.pool()[value];
    if (entry.operation != Operation::variable || entry.variable == 0)
      formulas.reject(column.formula, fmt::format("{}: must be a coordinate or its D(x, q)", column.name));
    if (!names.emplace(entry.variable, column.name).second) {
      formulas.reject(column.formula,
                      fmt::format("{}: must be of another column, one names this already", column.name));
    }
  }
  return names;
}

// Terms of order 1 come last: they need not be columns.
bool comes_before(const MemoryTerm& a, const MemoryTerm& b) { return a.order != 1.0 && b.order == 1.0; }

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

MechanicalFile read_mechanical_file(FileFormulas& formulas) {
  const auto& text = formulas.text();
  const auto& mechanics = *text.mechanics;
  MechanicalFile file;
  auto& system = file.system;
  for (const auto& coordinate : text.unknowns) system.coordinates.push_back(coordinate.name);
  ColumnVariables variables(system, formulas.pool());
  system.lagrangian = formulas.read(mechanics.lagrangian, variables.all(true, false));
  const bool has_ends = !system.memory.empty() || std::ranges::any_of(text.unknowns, [](const auto& one) {
    return !one.final.empty();
  });
  file.is_extremum = mechanics.is_vakonomic || has_ends;
  if (has_ends && !mechanics.is_vakonomic && !mechanics.constraints.empty()) {
    formulas.reject(mechanics.constraints.front(),
                    "constraints of an extremum with values at the end or D(x, a) in its Lagrangian: must be "
                    "of principle = "
                    "vakonomic");
  }
  for (const bool collect : {true, false}) {
    const auto of_all = variables.all(collect, !file.is_extremum);
    file.names = read_column_names(formulas, of_all);
    read_forces(system, formulas, of_all);
    read_constraints(system, formulas, of_all);
    std::ranges::stable_sort(system.memory, comes_before);
  }
  system.lagrangian = formulas.read(mechanics.lagrangian, variables.all(false, false));
  const bool two_sided = has_ends || (file.is_extremum && !system.memory.empty());
  const auto too_high =
      std::ranges::find_if(system.memory, [](const auto& term) { return term.order > 1.0; });
  if (file.is_extremum && too_high != system.memory.end()) {
    const auto& [coordinate, order] = *too_high;
    formulas.reject(mechanics.lagrangian, fmt::format("D({}, {}): must be of an order below 1 in an extremum",
                                                      system.coordinates[coordinate], order));
  }
  for (std::size_t k = 0; k < system.memory.size(); ++k)
    if (system.memory[k].order == 1.0 && !file.names.contains(system.w()[k])) ++system.unshown;
  if (!mechanics.multipliers.empty() && (two_sided || !file.is_extremum)) {
    formulas.reject(mechanics.multipliers.front(),
                    "multipliers: must be given only for principle = vakonomic with initial velocities");
  }
  if (mechanics.projects_velocity && two_sided)
    reject_at(text.file, mechanics.position, "initial_velocity: must be given only with initial velocities");
  file.starts_with_velocities = !two_sided;
  read_start(system, formulas, file.starts_with_velocities);
  if (file.is_extremum) file.ends = read_ends(system, formulas);
  file.has_positions_only = mechanics::is_memory_lagrangian(system, formulas.pool());
  return file;
}

std::vector<SystemColumn> columns_of(const MechanicalFile& file) {
  const auto& system = file.system;
  std::vector<SystemColumn> columns;
  const auto add = [&](const std::string& name, std::size_t unknown, double order) {
    const auto given = file.names.find(static_cast<int>(columns.size()) + 1);
    columns.push_back(
        {given == file.names.end() ? name : given->second, unknown, order, std::ssize(columns)});
  };
  for (std::size_t i = 0; i < system.size(); ++i) add(system.coordinates[i], i, 0.0);
  if (file.has_positions_only) return columns;
  for (std::size_t i = 0; i < system.size(); ++i) add(fmt::format("D({},1)", system.coordinates[i]), i, 1.0);
  for (const auto& [coordinate, order] : system.memory) {
    const bool is_named = file.names.contains(static_cast<int>(columns.size()) + 1);
    if (order != 1.0 || is_named)
      add(fmt::format("D({},{})", system.coordinates[coordinate], order), coordinate, order);
  }
  return columns;
}

Scene mechanical_file_scene(MechanicalFile file, FileFormulas& formulas, const Parameters& parameters,
                            const std::function<void(const std::string& note)>& on_note) {
  auto& pool = formulas.pool();
  auto& system = file.system;
  std::vector<std::string> names;
  const auto columns = columns_of(file);
  require_distinct(columns, formulas);
  for (const auto& column : columns) names.push_back(column.name);
  const double end = formulas.constant(formulas.text().end, "end", valid_end_times);
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
  auto all = mechanics::with_formulations({}, fitting);
  all.insert(all.end(), added.begin(), added.end());
  return all;
}

Parameters default_parameters(const EquationText& text) {
  std::vector<Parameter> declared;
  for (const auto& parameter : text.parameters) declared.push_back(parameter.declared);
  return {text.file, declared, {}};
}

}  // namespace fde::bench
