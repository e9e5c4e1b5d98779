// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/toml_text.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// Reads the parameters of a family of a study file. Each function throws std::invalid_argument naming file,
// line and column, the parameter, its value and what is allowed.
class StudyPoints : protected TomlReader {
 public:
  using TomlReader::TomlReader;

 protected:
  // Values of parameters, and of the end under the name "until".
  using Point = std::vector<std::pair<std::string, ParameterValue>>;

  // The points of a family: all combinations of its listed points, of the values of each parameter and of its
  // draws, the last varying fastest.
  [[nodiscard]] std::vector<SceneVariant> scenes_of(const toml::table& family, const TextPosition& place,
                                                    const SceneFactory& factory) const;

  [[nodiscard]] std::string text_value(const toml::node& node, std::string_view name) const;
  [[nodiscard]] double number_value(const toml::node& node, std::string_view name) const;
  [[nodiscard]] int count_value(const toml::node& node, std::string_view name, int lowest, int highest) const;

 private:
  using Axis = std::vector<Point>;  // values that vary together
  struct DrawnParameter;

  [[nodiscard]] std::vector<Axis> axes_of(const toml::table& family, const TextPosition& place,
                                          const SceneFactory& factory) const;
  [[nodiscard]] Axis listed_points(const toml::node& node, const SceneFactory& factory) const;
  [[nodiscard]] const Parameter& declared(const TomlEntry& entry, const SceneFactory& factory) const;
  [[nodiscard]] ParameterValue value_of(const toml::node& node, const Parameter& parameter) const;
  void require_allowed(const TextPosition& place, const ParameterValue& value,
                       const Parameter& parameter) const;
  [[nodiscard]] std::vector<ParameterValue> values_of(const toml::node& node,
                                                      const Parameter& parameter) const;
  [[nodiscard]] std::vector<ParameterValue> range_of(const toml::node& node,
                                                     const Parameter& parameter) const;
  [[nodiscard]] DrawnParameter drawn_of(const toml::node& node, const Parameter& parameter) const;
  [[nodiscard]] Axis draws_of(const toml::table& family, const std::vector<DrawnParameter>& drawn) const;
  [[nodiscard]] double number_at(const toml::table& of, const TextPosition& place, std::string_view name,
                                 std::string_view key) const;
  void require_one_sign(const TextPosition& place, std::string_view name, double from, double to) const;
};

}  // namespace fde::bench
