// SPDX-License-Identifier: MIT
#include "fdebench/reports/export/flat_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/reports/export/csv_cell.hpp"

namespace fde::bench {
namespace {

// The names, each once, in the order in which they come.
class Names {
 public:
  void add(std::string_view name) {
    if (std::ranges::find(names_, name) == names_.end()) names_.emplace_back(name);
  }
  [[nodiscard]] auto begin() const { return names_.begin(); }
  [[nodiscard]] auto end() const { return names_.end(); }

 private:
  std::vector<std::string> names_{};
};

class FlatRows {
 public:
  FlatRows(const std::vector<const Record*>& runs, const std::vector<SceneDescription>& scenes) {
    for (const SceneDescription& scene : scenes)
      for (const auto& parameter : scene.parameters) defaults_[scene.scene][parameter.name] = parameter.value;
    for (const Record* run : runs) {
      for (const auto& [name, value] : run->key.scene.values) parameters_.add(name);
      for (const auto* values : {&run->values, &run->timing.values})
        for (const auto& [quantity, value] : *values) quantities_.add(quantity);
    }
    add_cells("scene");
    for (const auto& name : parameters_) add_cells(std::string_view(column_of(name)));
    for (const std::string_view name : settings) add_cells(name);
    for (const auto& name : quantities_) add_cells(std::string_view(name));
    end_row();
    for (const Record* run : runs) add(*run);
  }

  [[nodiscard]] std::string csv() && { return std::move(csv_); }

 private:
  static constexpr std::array<std::string_view, 8> settings{"until",    "scheme",  "steps",   "h",
                                                            "accuracy", "grading", "history", "ending"};

  // A parameter may have the name of another column.
  [[nodiscard]] std::string column_of(const std::string& parameter) const {
    const bool is_taken = parameter == "scene" || std::ranges::find(settings, parameter) != settings.end() ||
                          std::ranges::find(quantities_, parameter) != quantities_.end();
    return (is_taken ? "parameter_" : "") + parameter;
  }

  // The value that the scene has, set or by default; empty: the scene has no such parameter, or is not
  // described.
  [[nodiscard]] std::string value_of(const SceneSettings& scene, const std::string& parameter) const {
    const auto set = scene.values.find(parameter);
    if (set != scene.values.end()) return to_text(set->second);
    const auto described = defaults_.find(scene);
    if (described == defaults_.end()) return "";
    const auto known = described->second.find(parameter);
    return known == described->second.end() ? "" : known->second;
  }

  template <typename... Cells>
  void add_cells(const Cells&... cells) {
    const auto add_one = [&](const Cell& cell) {
      if (is_begun_) csv_ += ',';
      append_csv(csv_, cell);
      is_begun_ = true;
    };
    (add_one(Cell(cells)), ...);
  }

  void end_row() {
    csv_ += csv_line_end;
    is_begun_ = false;
  }

  static Cell or_empty(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

  void add(const Record& run) {
    add_cells(std::string_view(run.key.scene.id));
    for (const auto& name : parameters_) add_cells(std::string_view(value_of(run.key.scene, name)));
    const auto* accuracy = std::get_if<Tolerance>(&run.key.settings.resolution);
    add_cells(or_empty(run.key.scene.until), std::string_view(run.key.scheme), std::int64_t{run.steps},
              run.h(), accuracy == nullptr ? Cell() : Cell(accuracy->rtol), run.key.settings.grading,
              run.key.external ? Cell() : Cell(name(run.key.settings.history)), name(run.ending.kind));
    for (const auto& quantity : quantities_) add_cells(or_empty(run[quantity]));
    end_row();
  }

  std::map<SceneSettings, std::map<std::string, std::string>> defaults_{};
  Names parameters_{}, quantities_{};
  std::string csv_{};
  bool is_begun_ = false;  // the present row has a cell
};

}  // namespace

FlatTable flat_table(const std::filesystem::path& file) {
  const Results read = read_results(file);
  std::map<RunKey, const Record*> latest;
  for (const Record& run : read.records) latest[run.key] = &run;
  std::vector<const Record*> runs;
  for (const Record& run : read.records)
    if (latest.at(run.key) == &run) runs.push_back(&run);
  return {FlatRows(runs, read.scenes).csv(), runs.size(), read.warning};
}

}  // namespace fde::bench
