// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/distributed_terms.hpp"
#include "fdebench/benchmarks/equation_files/equation_problem.hpp"
#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/equation_files/file_reference.hpp"
#include "fdebench/benchmarks/equation_files/file_smoothness.hpp"
#include "fdebench/benchmarks/equation_files/implied_rows.hpp"
#include "fdebench/benchmarks/equation_files/load_times.hpp"
#include "fdebench/benchmarks/equation_files/mechanical_equations.hpp"
#include "fdebench/benchmarks/equation_files/mechanical_file.hpp"
#include "fdebench/benchmarks/equation_files/output_columns.hpp"
#include "fdebench/benchmarks/equation_files/riemann_liouville.hpp"
#include "fdebench/benchmarks/equation_files/shown_equations.hpp"
#include "fdebench/benchmarks/equation_files/table_times.hpp"
#include "fdebench/benchmarks/equation_files/transfer_function.hpp"
#include "fdebench/benchmarks/equation_files/vector_components.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

// Refuses arguments of tables that leave their samples, now and wherever another end is set.
void check_samples(Scene& scene, FileFormulas& formulas) {
  const auto check = samples_check(formulas);
  if (!check) return;
  check(scene.problem.end);
  scene.load_times = [check, times = scene.load_times](double end) {
    check(end);
    return times(end);
  };
}

// Formulas of the columns, and of t if `time`.
Program program_of(const std::vector<FormulaText>& texts, const std::vector<SystemColumn>& columns,
                   FileFormulas& formulas, bool time = true) {
  std::vector<Expression> values;
  for (const auto& text : texts) values.push_back(formulas.read(text, variables_of(columns, formulas, time)));
  return {formulas.pool(), values, std::ssize(columns)};
}

// The outputs that are infinite at t = 0, beside their own columns.
Outputs singular_outputs(const std::vector<SystemColumn>& columns, FileFormulas& formulas) {
  std::vector<std::string> names;
  std::vector<FormulaText> values;
  for (const auto& output : formulas.text().outputs) {
    if (!output.weighted || !formulas.text().columns.empty()) continue;
    names.push_back(output.name);
    values.push_back({.text = output.name, .position = output.terms.front().order.position});
  }
  return names.empty() ? Outputs{} : Outputs{names, program_of(values, columns, formulas)};
}

Energy energy_of(const EnergyText& text, const std::vector<SystemColumn>& columns, FileFormulas& formulas) {
  Energy energy{.value = [program = program_of({text.value}, columns, formulas, false)](In c) {
    return program(0.0, c);
  }};
  if (text.power) energy.power = program_of({*text.power}, columns, formulas);
  return energy;
}

SceneEvent event_of(const EventText& text, const std::vector<SystemColumn>& columns, FileFormulas& formulas) {
  SceneEvent event{text.name, program_of({text.zero}, columns, formulas), text.crossing, text.terminal};
  const auto zero = formulas.read(text.zero, variables_of(columns, formulas, true));
  if (!formulas.pool().depends_on_unknowns(zero)) event.times = times_between_zeros(zero, formulas.pool());
  return event;
}

// The domain in the columns of both forms of a problem.
void set_domain(Scene& scene, const DomainText& text, const std::vector<SystemColumn>& columns,
                FileFormulas& formulas) {
  const auto program = program_of({text.positive}, columns, formulas);
  const auto restrict_to = [&](Domain& domain, const Outputs& outputs) {
    domain.edge = domain.edge.empty() ? text.edge : text.edge + ", or " + domain.edge;
    domain.margin = [program, outputs](double t, In y) { return program(t, columns_at(outputs, t, y)); };
  };
  restrict_to(scene.problem.domain, scene.outputs);
  if (scene.reference_problem)
    restrict_to(scene.reference_problem->problem.domain, scene.reference_problem->outputs);
}

// Marks rows as not measured that are not columns, if all columns are rows.
void exclude_unshown_rows(Smoothness& smoothness, const std::vector<SystemColumn>& columns,
                          Eigen::Index size) {
  if (std::ranges::any_of(columns, [](const SystemColumn& column) { return column.row < 0; })) return;
  for (Eigen::Index row = 0; row < size; ++row) {
    if (std::ranges::find(columns, row, &SystemColumn::row) == columns.end())
      smoothness.unmeasured.push_back(row);
  }
}

// The path of a point in the plane or in space, from the columns.
Outputs path_of(const std::vector<NamedFormula>& coordinates, const std::vector<SystemColumn>& columns,
                FileFormulas& formulas) {
  std::vector<std::string> names;
  std::vector<FormulaText> texts;
  for (const auto& coordinate : coordinates) {
    names.push_back(coordinate.name);
    texts.push_back(coordinate.formula);
  }
  return {names, program_of(texts, columns, formulas)};
}

Scene mechanical_scene_of(const EquationText& text, const Parameters& parameters,
                          const NoteReceiver& on_note) {
  FileFormulas formulas(text, parameters, NumberStorage::values);
  formulas.require_parameters();
  const auto file = read_mechanical_file(formulas);
  Scene scene = mechanical_file_scene(file, formulas, parameters, on_note);
  scene.start = formulas.start();
  scene.from_file = !text.is_built_in;
  auto applied = file.system.forces;
  applied.push_back(file.system.lagrangian);
  for (const auto rate : formulas.pool().derivatives(file.system.constraints, 0)) applied.push_back(rate);
  scene.load_times = load_times(applied, declared_jumps(formulas), formulas.pool());
  set_end(scene, scene.problem.end);
  const auto columns = columns_of(file);
  if (text.domain) set_domain(scene, *text.domain, columns, formulas);
  for (const auto& event : text.events) scene.events.push_back(event_of(event, columns, formulas));
  if (!text.path.empty()) scene.display_path = path_of(text.path, columns, formulas);
  if (!text.exact.empty()) scene.reference = exact_columns(text, parameters, columns, columns);
  check_samples(scene, formulas);
  return scene;
}

Domain domain_of(const DomainText& text, const EquationSystem& system, FileFormulas& formulas) {
  const auto margin = formulas.read(text.positive, variables_of(system, formulas.pool()));
  return {.edge = text.edge, .margin = Program(formulas.pool(), {margin}, system.size())};
}

// The text without parts that are left out, and with states in place of transfer functions.
EquationText in_states(EquationText text, const Parameters& parameters, const QuadratureNodes& nodes = {}) {
  text = with_components(present_parts(std::move(text), parameters), parameters);
  return with_states(with_quadrature(std::move(text), parameters, nodes), parameters);
}

// The transfer functions, P as the terms of an output and Q as those of its state.
std::vector<TransferFunction> transfers_of(const EquationText& all, const Parameters& parameters) {
  std::vector<TransferFunction> transfers;
  const auto has_transfer = [](const UnknownText& one) { return one.transfer.has_value(); };
  if (std::ranges::none_of(all.unknowns, has_transfer)) return transfers;
  const EquationText text = in_states(all, parameters);
  FileFormulas formulas(text, parameters, NumberStorage::values);
  const auto numbers = [&](const std::vector<TermText>& terms) {
    std::vector<TransferFunction::Term> sum;
    for (const auto& [coefficient, order] : terms) {
      sum.push_back({formulas.constant(coefficient, "coefficient", any_number),
                     formulas.constant(order, "order", any_number)});
    }
    return sum;
  };
  for (const auto& output : text.outputs) {
    const auto state = std::ranges::find(text.unknowns, output.state, &UnknownText::name);
    transfers.push_back({output.name, numbers(output.terms), numbers(state->terms)});
  }
  return transfers;
}

// The text in which all equations are sums of terms of one unknown each.
EquationText in_terms(EquationText text, const Parameters& parameters, const QuadratureNodes& nodes = {}) {
  text = with_implied_rows(in_states(std::move(text), parameters, nodes), parameters);
  return with_implied_terms(with_caputo_derivatives(std::move(text), parameters), parameters);
}

// A text as equations, a problem and its columns.
struct PosedText {
  PosedText(EquationText written, const Parameters& parameters)
      : text(std::move(written)),
        formulas(text, parameters, NumberStorage::values),
        system(read_system(formulas)),
        columns(output_columns(system, formulas)) {}

  [[nodiscard]] reference::Reference reference() {
    return file_reference(system, problem_of(system, formulas), columns, formulas);
  }
  [[nodiscard]] PosedProblem posed() {
    return {problem_of(system, formulas), outputs_of(columns, system.size(), formulas.pool())};
  }

  const EquationText text;
  FileFormulas formulas;
  const EquationSystem system;
  const std::vector<SystemColumn> columns;
};

// Numbers of nodes that the quadratures of references have beside those of schemes.
constexpr int more_nodes = 2, many_more_nodes = 4;

// The reference of the columns, up to another end if one is given; with distributed orders of a quadrature
// with more nodes, whose difference to a still finer one is in the bound. Empty: there is none but by two
// methods. The columns of unknowns that are infinite at t = 0 are those for the end of the file.
reference::Reference known_reference(const EquationText& all, const Parameters& parameters,
                                     std::optional<double> end = {}) {
  const auto with_nodes = [&](int more) {
    EquationText text = in_terms(all, parameters, {more, end});
    if (end) {
      text.end = {.text = fmt::format("{} + ({})", *end, all.start ? all.start->text : "0"),
                  .position = all.end.position};
    }
    return PosedText(std::move(text), parameters).reference();
  };
  if (!has_distributed_orders(all) || !all.exact.empty()) return with_nodes(0);
  return reference::with_difference(with_nodes(many_more_nodes), with_nodes(many_more_nodes + more_nodes));
}

// The names of rows, also of those that are no columns.
std::vector<std::string> row_names(const EquationSystem& system, const EquationText& text) {
  std::vector<std::string> names(static_cast<std::size_t>(system.size()));
  for (const auto& column : columns_of(system)) {
    const auto& meaning = text.unknowns[column.unknown].meaning;
    names[static_cast<std::size_t>(column.row)] = meaning.empty() ? column.name : meaning;
  }
  return names;
}

// The event functions of events that set unknowns.
std::vector<Expression> functions_of_resets(const EquationSystem& system, FileFormulas& formulas) {
  std::vector<Expression> functions;
  for (const auto& event : formulas.text().events) {
    if (!event.set.empty())
      functions.push_back(formulas.read(event.zero, variables_of(system, formulas.pool())));
  }
  return functions;
}

// Whether the reference is made for one end: with values there, or a term for each step of a load by floor.
bool has_reference_to_end(const EquationSystem& system, const ExpressionPool& pool) {
  const auto is_floor = [](const ExpressionPool::Node& node) { return node.operation == Operation::floor; };
  return !system.final.empty() || !pool.arguments(system.rows, is_floor).empty();
}

Scene scene_of(const EquationText& all, const Parameters& parameters, const NoteReceiver& on_note) {
  const EquationText text = in_terms(all, parameters);
  if (text.mechanics) return mechanical_scene_of(text, parameters, on_note);
  FileFormulas formulas(text, parameters, NumberStorage::values);
  formulas.require_parameters();
  const auto system = read_system(formulas);
  const auto columns = output_columns(system, formulas);
  if (const auto check = samples_check(formulas)) check(system.end);  // before problem_of() evaluates them
  Scene scene{
      .problem = problem_of(system, formulas), .start = formulas.start(), .from_file = !text.is_built_in};
  if (text.domain) scene.problem.domain = domain_of(*text.domain, system, formulas);
  const auto started = with_some_initial_values(system);
  scene.smoothness = file_smoothness(started, with_some_initial_values(scene.problem), formulas);
  exclude_unshown_rows(scene.smoothness, columns, system.size());
  scene.outputs = outputs_of(columns, system.size(), formulas.pool());
  scene.row_names = row_names(system, text);
  scene.load_times =
      load_times(system.rows, system.jumps, formulas.pool(), functions_of_resets(system, formulas));
  set_end(scene, system.end);
  scene.reference = has_distributed_orders(all) ? known_reference(all, parameters)
                                                : file_reference(system, scene.problem, columns, formulas);
  if (scene.reference.at && (has_distributed_orders(all) || has_reference_to_end(system, formulas.pool())))
    scene.reference_to = [all, parameters](double end) { return known_reference(all, parameters, end); };
  if (!scene.reference.at && has_distributed_orders(all))
    scene.comparison_problem = PosedText(in_terms(all, parameters, {.more = more_nodes}), parameters).posed();
  if (!scene.reference.at && scene.problem.resets.empty())
    scene.reference_problem = without_singular_loads(system, scene.problem, columns, formulas.pool());
  scene.singular = singular_outputs(columns, formulas);
  scene.transfers = transfers_of(all, parameters);
  if (text.energy) scene.energy = energy_of(*text.energy, columns, formulas);
  for (const auto& event : text.events) scene.events.push_back(event_of(event, columns, formulas));
  if (const auto& f = text.constraints; !f.empty())
    scene.constraint = {.size = std::ssize(f), .value = program_of(f, columns, formulas)};
  if (!text.path.empty()) scene.display_path = path_of(text.path, columns, formulas);
  scene.discontinuities = file_discontinuities(started, formulas);
  check_samples(scene, formulas);
  return scene;
}

SceneFactory factory_of(EquationText text, const NoteReceiver& on_note) {
  const auto kept = std::make_shared<const EquationText>(std::move(text));
  const std::filesystem::path file = kept->file;
  SceneFactory factory{
      .id = kept->file,
      .title = kept->title.empty() ? file.stem().string() : kept->title,
      .source = kept->source.empty() ? kept->file : kept->source,
      .parameters = {},
      .make = [=](const Parameters& parameters) { return scene_of(*kept, parameters, on_note); },
      .checksum = kept->is_built_in ? "" : sha256(kept->meaning),
      .toml = kept->contents};
  for (const auto& parameter : kept->parameters) factory.parameters.push_back(parameter.declared);
  if (kept->mechanics) {
    for (auto& parameter : formulation_parameters(*kept)) factory.parameters.push_back(std::move(parameter));
    factory.equations = mechanical_equations(*kept);
    if (!are_readable(factory.equations)) factory.display_equations = mechanical_statements(*kept);
    return factory;
  }
  set_equations(kept->unknowns, factory);
  return factory;
}

// The folder of the user's equation files; empty if there is none.
std::filesystem::path scene_folder() {
  const char* folder = std::getenv("FDEBENCH_SCENES");  // NOLINT(concurrency-mt-unsafe): nothing sets it
  return folder == nullptr ? "" : folder;
}

// The file of this name in the user's folder; nullopt if there is none.
std::optional<std::filesystem::path> file_in_folder(std::string_view id) {
  const auto folder = scene_folder();
  if (folder.empty() || id.find('/') != std::string_view::npos) return std::nullopt;
  auto file = folder / fmt::format("{}{}", id, equation_file_extension);
  return std::filesystem::exists(file) ? std::optional(file) : std::nullopt;
}

std::optional<SceneFactory> scene_of_file(std::string_view name, const NoteReceiver& on_note) {
  const std::string id(name);
  if (name.ends_with(equation_file_extension)) {
    if (!is_printable(id)) reject_text("scene", id, "a file whose name is UTF-8 that prints");
    return equation_scene(read_equation_text(id), on_note);
  }
  const auto file = file_in_folder(name);
  if (!file && name.find_first_of("./\\") != std::string_view::npos)
    reject_text("scene", id, "the id of a scene, or an equation file, whose name ends in .toml");
  if (!file && std::filesystem::exists(fmt::format("{}{}", id, equation_file_extension)))
    reject_text("scene", id, fmt::format("a scene; the file is {}{}", id, equation_file_extension));
  if (!file) return std::nullopt;
  SceneFactory factory = equation_scene(read_equation_text(*file), on_note);
  factory.id = id;
  return factory;
}

}  // namespace

SceneFactory equation_scene(EquationText text, const NoteReceiver& on_note) {
  return factory_of(std::move(text), on_note);
}

SceneFactory built_in_scene(const std::string& id, std::string_view toml) {
  auto text = parse_equation_text(id, toml);
  text.is_built_in = true;
  return factory_of(std::move(text), {});
}

SceneRegistry with_equation_files(const SceneRegistry& scenes, NoteReceiver on_note) {
  for (const auto id : scenes.ids()) {
    if (const auto file = file_in_folder(id)) {
      throw std::invalid_argument(
          fmt::format("{}: must have another name, the scene {} is built in", file->string(), id));
    }
  }
  return {scenes,
          [on_note = std::move(on_note)](std::string_view name) { return scene_of_file(name, on_note); }};
}

std::vector<std::string> names_in_scene_folder() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(scene_folder(), ignored)) {
    if (entry.path().extension() == equation_file_extension) names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace fde::bench
