// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <map>
#include <memory>
#include <stdexcept>

#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/reference_data/table_kind.hpp"
#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"

namespace fde::bench {
namespace {

constexpr std::array table_steps{64, 128, 256, 512, 1024, 2048, 4096};
constexpr int most_steps = 1 << 20;

// Tolerances for another machine, whose vector instructions sum in another order: relative to the error, and
// to 1 + max |y|. The two history engines, which sum in different ways, differ by at most a tenth of this.
constexpr double relative_tolerance = 1e-9;
constexpr double rounding_tolerance = 1e-12;
constexpr double least_accuracy = 1e-8;  // of a reference, for a check to be meaningful

// The measures that are columns of a row.
const std::vector<std::string> measured{"h", "error_end", "error_maximum", "expected_rate_end",
                                        "expected_rate_maximum"};

// Whether a scene has this measure: not every scene has theoretical rates.
bool has_measure(const Scene& scene, const std::string& name) {
  return !name.starts_with("expected_rate") || !scene.smoothness.powers.empty();
}

TableMetadata convergence_facts(const SceneVariant& of) {
  const Scene scene = make_scene(of);
  TableMetadata facts{
      .title = fmt::format("{}: errors of every scheme against the number of steps", of.factory->title),
      .method = fmt::format("each scheme on a uniform grid of [0, {}], compared at every step with the "
                            "reference, in double; reproducible to {:g} of the error and {:g} of 1 + max |y|",
                            scene.problem.end, relative_tolerance, rounding_tolerance),
      .source = std::string(of.factory->source),
      .bound = "of the reference at the end, against which the errors are measured",
      .digits = double_digits,
      .columns = {
          {.name = "scheme", .description = "id of the scheme", .type = ColumnType::text, .argument = true},
          {.name = "steps",
           .description = "number of steps",
           .type = ColumnType::integer,
           .argument = true,
           .minimum = 1},
          {.name = "h", .description = "step size", .required = false, .minimum = 0},
          {.name = "error_end",
           .description = "largest error over the columns at the last time",
           .minimum = 0},
          {.name = "error_maximum",
           .description = "largest error over the columns and all steps",
           .required = false,
           .minimum = 0},
          {.name = "expected_rate_end", .description = "theoretical rate at a fixed time", .required = false},
          {.name = "expected_rate_maximum",
           .description = "theoretical rate in the maximum norm",
           .required = false},
          {.name = "bound",
           .description = "bound of the reference at the end",
           .required = false,
           .minimum = 0}}};
  std::erase_if(facts.columns, [&](const auto& column) { return !has_measure(scene, column.name); });
  return facts;
}

// The runs of one scene, which share cached reference values.
class Runs {
 public:
  explicit Runs(const SceneVariant& of) : name_(of.key()), scene_(make_scene(of)), reference_(scene_) {}
  Runs& operator=(Runs&&) = delete;

  struct Run {
    std::map<std::string, double> values;  // by name of the measure
    RunOutcome ending;
  };

  Run operator()(const Scheme& scheme, int steps) {
    if (!scheme.expected_rate)
      return {.values = {}, .ending = {SolveStatus::refused, "has no theoretical rate"}};
    const Record record = examine(name_, scene_, reference_, scheme, {steps});
    Run run{.values = {{"h", record.h()}}, .ending = record.ending};
    for (const auto& [quantity, value] : record.values) run.values.emplace(quantity, value);
    return run;
  }

  [[nodiscard]] bool has(const std::string& name) const { return has_measure(scene_, name); }

  // max |y| over the time interval of the scene.
  double size() {
    const Grid grid{.end = scene_.problem.end, .steps = table_steps.front()};
    return reference_.at(comparison_times(grid)).cwiseAbs().maxCoeff();
  }

 private:
  SceneSettings name_;
  Scene scene_;
  MemoizedReference reference_;
};

ComputedTable convergence_rows(const SceneVariant& of) {
  Runs runs(of);
  ComputedTable made;
  for (const auto& column : convergence_facts(of).columns) made.table.columns.push_back(column.name);
  for (const auto& scheme : schemes()) {
    for (const int steps : table_steps) {
      const auto [values, ending] = runs(scheme, steps);
      if (ending.kind != SolveStatus::finished) {
        const bool refused = ending.kind == SolveStatus::refused;
        const std::string id(scheme.id);
        made.left_out.push_back({refused ? id : fmt::format("{}, {} steps", id, steps), sentence(ending)});
        if (refused) break;
        continue;
      }
      std::vector<std::string> row{std::string(scheme.id), fmt::format("{}", steps)};
      for (const auto& name : measured)
        if (runs.has(name)) row.push_back(fmt::format("{}", values.at(name)));
      row.push_back(bound_text(values.at("reference_bound")));
      made.table.rows.push_back(std::move(row));
    }
  }
  return made;
}

const Scheme& scheme_at(const DataTable& given, std::size_t row) {
  const auto& id = given.rows[row][*given.find("scheme")];
  if (const Scheme* scheme = find_scheme(id)) return *scheme;
  std::vector<std::string_view> ids;
  for (const auto& scheme : schemes()) ids.push_back(scheme.id);
  throw InvalidTable(fmt::format("{}: no such scheme '{}'; there are {}", given.place(row, "scheme"), id,
                                 fmt::join(ids, ", ")));
}

int steps_at(const DataTable& given, std::size_t row) {
  const auto& text = given.rows[row][*given.find("steps")];
  int steps = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), steps);
  if (error == std::errc{} && end == text.data() + text.size() && steps >= 1 && steps <= most_steps)
    return steps;
  throw InvalidTable(fmt::format("{}: '{}' must be a whole number from 1 to {}", given.place(row, "steps"),
                                 text, most_steps));
}

RowCheck convergence_check(const SceneVariant& of, const DataTable& given) {
  const auto comparison = std::make_shared<TableComparison>(given, measured);
  const auto runs = std::make_shared<Runs>(of);
  return [&given, comparison, runs](std::size_t row) {
    const auto [values, ending] = (*runs)(scheme_at(given, row), steps_at(given, row));
    if (ending.kind != SolveStatus::finished) throw std::runtime_error(sentence(ending));
    const double size = 1.0 + runs->size(), bound = values.at("reference_bound");
    if (!(bound <= least_accuracy * size))
      throw std::runtime_error(fmt::format("the reference has a bound of {}", bound_text(bound)));
    const double of_errors = rounding_tolerance * size + bound;
    std::vector<reference::Decimal> recomputed;
    for (const auto& name : measured) {
      const double value = runs->has(name) ? values.at(name) : 0.0;
      const double tolerance =
          name.starts_with("error") ? relative_tolerance * value + of_errors : rounding_tolerance * value;
      recomputed.push_back({fmt::format("{}", value), fmt::format("{}", tolerance)});
    }
    return (*comparison)(row, recomputed);
  };
}

}  // namespace

const TableKind convergence_table{.id = "convergence",
                                  .folder = "convergence",
                                  .identifying_column = "scheme",
                                  .facts = convergence_facts,
                                  .make = convergence_rows,
                                  .check = convergence_check};

}  // namespace fde::bench
