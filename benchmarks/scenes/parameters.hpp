// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {

// A number, a choice, or a list of numbers.
using ParameterValue = std::variant<double, std::string, std::vector<double>>;
using ParameterValues = std::map<std::string, ParameterValue>;  // keyed by parameter name

// "0.5", "multiplier", "0.5,1.5": numbers with the fewest digits that read back to the same double.
std::string to_text(const ParameterValue& value);

// The value from this text without its parameter: a number, a list of two or more numbers, or a word.
ParameterValue parse_value(std::string_view text);

// A parameter of a scene: a number in a range, one of a list of words, or a list of numbers in a range.
struct Parameter {
  std::string name;
  ParameterValue value;  // the default
  Range range;           // of a number, or of each number of a list
  std::string description;
  std::vector<std::string> choices{};  // allowed words
  std::string default_formula{};       // formula that gives a number by default; empty: none
  bool keeps_solution = false;         // the exact columns are the same for all its values

  [[nodiscard]] bool allows(const ParameterValue& given) const;
  // "a number in (0, 2]", "one of a, b", "a finite number, or a*q1"
  [[nodiscard]] std::string allowed() const;
  // Parses a value: one of the choices, any number, the formula `default_formula`, or a list of numbers
  // (empty text: empty list). A number is not compared with the range. Throws std::invalid_argument naming
  // the parameter, the text and what is allowed.
  [[nodiscard]] ParameterValue read(std::string_view text) const;
};

// A parameter with one of these words; the first is the default.
Parameter choice(std::string name, std::vector<std::string> choices, std::string meaning);

// A number whose default is given by this formula in other parameters.
Parameter derived_number(std::string name, std::string formula, Range range, std::string meaning);

// A list of numbers, each in the range.
Parameter list_of_numbers(std::string name, std::vector<double> numbers, Range range, std::string meaning);

// The parameter with this name. Throws std::invalid_argument if the scene has no such parameter.
const Parameter& parameter_named(std::string_view name, std::string_view scene,
                                 const std::vector<Parameter>& parameters);

// Values of all parameters of one scene.
class Parameters {
 public:
  // The defaults with some values replaced. Throws std::invalid_argument naming the parameter, the value and
  // what is allowed, when a name is unknown or a value is not allowed.
  Parameters(std::string_view scene, const std::vector<Parameter>& parameters, const ParameterValues& values);

  // Each throws std::out_of_range for an unknown name and std::bad_variant_access for a parameter of another
  // type.
  double operator[](std::string_view name) const;                                 // a number
  [[nodiscard]] const std::string& choice(std::string_view name) const;           // the word chosen
  [[nodiscard]] const std::vector<double>& numbers(std::string_view name) const;  // a list

  // The number given for a parameter that has a `default_formula`; nullopt if that formula gives it. Throws
  // std::out_of_range for an unknown name.
  [[nodiscard]] std::optional<double> explicit_value(std::string_view name) const;

  // Its value. Throws std::out_of_range for an unknown name.
  [[nodiscard]] const ParameterValue& value(std::string_view name) const;

  [[nodiscard]] std::string text() const;  // "a=1 b=0.5 c=word", sorted by name

 private:
  ParameterValues values_;
};

// Throws std::invalid_argument: "NAME = VALUE: must be ALLOWED".
[[noreturn]] void reject(std::string_view name, const ParameterValue& value, std::string_view allowed);

// Identifies a scene in results: its id and the replaced parameters. This build need not have a scene of this
// id.
struct SceneSettings {
  std::string id{};
  ParameterValues values{};
  std::optional<double> until{};  // the end of the time interval
  std::string checksum{};         // of the contents of the equation file at path `id`; empty: compiled in

  auto operator<=>(const SceneSettings&) const = default;
};

// For display: "pendulum", "pendulum:alpha=1.9,until=100"; settings_text is the part after the colon.
std::string label_of(const SceneSettings& scene);
std::string settings_text(const SceneSettings& scene);
// The first eight digits of the checksum, which distinguish files of the same name; empty without a file.
std::string short_checksum(const SceneSettings& scene);

}  // namespace fde::bench
