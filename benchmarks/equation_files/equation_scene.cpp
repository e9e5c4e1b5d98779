// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/equation_files/exact_columns.hpp"
#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/equation_files/start_powers.hpp"
#include "fdebench/benchmarks/equation_files/time_jumps.hpp"
#include "fdebench/benchmarks/scenes/equation_file_name.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

// The components themselves if they are the columns.
Outputs outputs_of(const std::vector<SystemColumn>& columns) {
  std::vector<std::string> names;
  std::vector<Eigen::Index> rows;
  bool same = true;
  for (const auto& column : columns) {
    same = same && column.row == std::ssize(rows);
    names.push_back(column.name);
    rows.push_back(column.row);
  }
  return same ? Outputs{names} : select_components(names, rows);
}

Energy energy_of(const EnergyText& text, const std::vector<SystemColumn>& columns, FileFormulas& formulas) {
  auto& pool = formulas.pool();
  const auto size = std::ssize(columns);
  const auto value = formulas.read(text.value, variables_of(columns, pool, false));
  Energy energy{.value = [program = Program(pool, {value}, size)](In c) { return program(0.0, c); }};
  if (text.power) {
    const auto power = formulas.read(*text.power, variables_of(columns, pool, true));
    energy.power = Program(pool, {power}, size);
  }
  return energy;
}

Constraint constraint_of(const std::vector<FormulaText>& texts, const std::vector<SystemColumn>& columns,
                         FileFormulas& formulas) {
  std::vector<Expression> values;
  for (const auto& text : texts)
    values.push_back(formulas.read(text, variables_of(columns, formulas.pool(), true)));
  return {.size = std::ssize(values),
          .value = [program = Program(formulas.pool(), values, std::ssize(columns))](double t, In c, Out f) {
            program.evaluate(t, c, {f.data(), static_cast<std::size_t>(f.size())});
          }};
}

SceneEvent event_of(const EventText& text, const std::vector<SystemColumn>& columns, FileFormulas& formulas) {
  const auto value = formulas.read(text.zero, variables_of(columns, formulas.pool(), true));
  return {text.name, Program(formulas.pool(), {value}, std::ssize(columns)), text.crossing, text.terminal};
}

// Rejects an exact column whose value at t = 0 differs from the initial value. A value that is not finite at
// t = 0 is not checked.
void require_exact_start(const EquationText& text, const std::vector<SystemColumn>& columns,
                         const Scene& scene) {
  constexpr double rounding = 1e-9;
  const auto [value, bound] = scene.reference.at(0.0);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto& initial = scene.problem.components[static_cast<std::size_t>(columns[c].row)].initial;
    const double at_start = value[static_cast<Eigen::Index>(c)];
    if (initial.empty() || !std::isfinite(at_start)) continue;
    if (std::abs(at_start - initial.front()) <= rounding * (1.0 + std::abs(initial.front()))) continue;
    reject_at(text.file, text.exact.front().position,
              fmt::format("exact: {} is {:.6g} at t = 0: must be {:.6g}, its initial value", columns[c].name,
                          at_start, initial.front()));
  }
}

Scene scene_of(const EquationText& text, const Parameters& parameters) {
  FileFormulas formulas(text, parameters, NumberStorage::values);
  const auto system = read_system(formulas);
  const auto columns = columns_of(system);
  Scene scene{.problem = problem_of(system, formulas),
              .smoothness = starting_powers(system, formulas.pool()),
              .outputs = outputs_of(columns),
              .from_file = true};
  scene.jumps_until = time_jumps(system, formulas.pool());
  set_end(scene, system.end);
  if (!text.exact.empty()) {
    scene.reference = exact_columns(text, parameters, columns);
    require_exact_start(text, columns, scene);
  } else if (auto motion = linear_file_reference(system, scene.problem, formulas.pool())) {
    scene.reference = std::move(*motion);
  }
  if (text.energy) scene.energy = energy_of(*text.energy, columns, formulas);
  for (const auto& event : text.events) scene.events.push_back(event_of(event, columns, formulas));
  if (!text.constraints.empty()) scene.constraint = constraint_of(text.constraints, columns, formulas);
  return scene;
}

std::optional<SceneFactory> scene_of_file(std::string_view name) {
  if (!name.ends_with(equation_file_extension)) return std::nullopt;
  const std::string file(name);
  if (!is_printable(file)) reject_text("scene", file, "a file whose name is UTF-8 that prints");
  return equation_scene(read_equation_text(file));
}

EquationFormula written(const UnknownText& unknown) {
  EquationFormula equation{.unknown = unknown.name, .terms = {}, .rhs = unknown.rhs.text, .initial = {}};
  for (const auto& [coefficient, order] : unknown.terms)
    equation.terms.push_back({coefficient.text, order.text});
  for (const auto& value : unknown.initial) equation.initial.push_back(value.text);
  return equation;
}

}  // namespace

SceneFactory equation_scene(EquationText text) {
  const auto kept = std::make_shared<const EquationText>(std::move(text));
  const std::filesystem::path file = kept->file;
  SceneFactory maker{.id = kept->file,
                     .title = kept->title.empty() ? file.stem().string() : kept->title,
                     .source = kept->file,
                     .parameters = {},
                     .make = [kept](const Parameters& parameters) { return scene_of(*kept, parameters); },
                     .checksum = kept->checksum};
  for (const auto& [name, value] : kept->parameters)
    maker.parameters.push_back({name, value, any_number, "of the file"});
  for (const auto& unknown : kept->unknowns) maker.equations.push_back(written(unknown));
  return maker;
}

SceneRegistry with_equation_files(const SceneRegistry& scenes) { return {scenes, scene_of_file}; }

}  // namespace fde::bench
