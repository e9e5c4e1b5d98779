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

#include "fdebench/benchmarks/records/results_index.hpp"
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

// Reads the latest runs twice: for the names of the columns, then for the rows.
class FlatRows {
 public:
  FlatRows(const std::filesystem::path& file, std::ostream& out)
      : index_(index_results(file)), lines_(file), out_(out) {}

  FlatCounts write() && {
    FlatCounts counts{.warning = index_.warning};
    for_each_latest([&](const Record& run) { add_names(run); });
    write_header();
    for_each_latest([&](const Record& run) {
      add(run);
      ++counts.rows;
    });
    return counts;
  }

 private:
  static constexpr std::array<std::string_view, 8> settings{"until",    "scheme",  "steps",   "h",
                                                            "accuracy", "grading", "history", "ending"};

  // A parameter may have the name of another column.
  [[nodiscard]] std::string column_of(const std::string& parameter) const {
    const bool is_taken = parameter == "scene" || std::ranges::find(settings, parameter) != settings.end() ||
                          std::ranges::find(quantities_, parameter) != quantities_.end();
    return (is_taken ? "parameter_" : "") + parameter;
  }

  template <typename Function>
  void for_each_latest(const Function& function) const {
    for (const IndexedRun& run : index_.runs)
      if (run.is_latest) function(read_record(lines_, run));
  }

  void add_names(const Record& run) {
    for (const auto& [name, value] : run.key.scene.values) parameters_.add(name);
    for (const auto* values : {&run.values, &run.timing.values})
      for (const auto& [quantity, value] : *values) quantities_.add(quantity);
  }

  void write_header() {
    add_cells("scene");
    for (const auto& name : parameters_) add_cells(std::string_view(column_of(name)));
    for (const std::string_view name : settings) add_cells(name);
    for (const auto& name : quantities_) add_cells(std::string_view(name));
    end_row();
  }

  // The defaults of the scene's parameters; empty without a description. The runs of a scene mostly follow
  // each other, so that only the defaults of the last one are kept.
  const std::map<std::string, std::string>& defaults_of(const SceneSettings& scene) {
    if (last_scene_ == scene) return defaults_;
    last_scene_ = scene;
    defaults_.clear();
    for (const auto description : index_.scenes.at(scene)) {
      for (const auto& parameter : read_scene(lines_, description).parameters)
        defaults_[parameter.name] = parameter.value;
    }
    return defaults_;
  }

  // The value that the scene has, set or by default; empty: the scene has no such parameter, or is not
  // described.
  [[nodiscard]] std::string value_of(const SceneSettings& scene, const std::string& parameter) {
    const auto set = scene.values.find(parameter);
    if (set != scene.values.end()) return to_text(set->second);
    const auto& defaults = defaults_of(scene);
    const auto known = defaults.find(parameter);
    return known == defaults.end() ? "" : known->second;
  }

  template <typename... Cells>
  void add_cells(const Cells&... cells) {
    const auto add_one = [&](const Cell& cell) {
      if (is_begun_) row_ += ',';
      append_csv(row_, cell);
      is_begun_ = true;
    };
    (add_one(Cell(cells)), ...);
  }

  void end_row() {
    out_ << row_ << csv_line_end;
    row_.clear();
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

  ResultsIndex index_;
  LinesByOffset lines_;
  std::ostream& out_;
  std::optional<SceneSettings> last_scene_{};
  std::map<std::string, std::string> defaults_{};  // of that scene
  Names parameters_{}, quantities_{};
  std::string row_{};
  bool is_begun_ = false;  // the present row has a cell
};

}  // namespace

FlatCounts write_flat_table(const std::filesystem::path& file, std::ostream& out) {
  return FlatRows(file, out).write();
}

}  // namespace fde::bench
