// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/mechanical_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdebench/benchmarks/mechanics/memory_extremum.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {
namespace {

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
    if (!formulas.pool().arguments({system.constraints.back()}, jumps).empty()) {
      formulas.reject(
          constraint,
          "has a sign, a step, a floor or a table that jumps: must be continuous, for the velocity "
          "would jump with it");
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
    if (!coordinate.final.empty()) last = formulas.constant(coordinate.final[0].formula, "final", any_number);
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

}  // namespace fde::bench
