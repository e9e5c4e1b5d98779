#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scenes/entry_named.hpp"
#include "scenes/range.hpp"

namespace fde {

// A number, the word of a choice, or a list of numbers.
using ParameterValue = std::variant<double, std::string, std::vector<double>>;
using ParameterValues = std::map<std::string, ParameterValue>;  // by the names of the parameters

// "0.5", "multiplier", "0.5,1.5": numbers in the fewest digits that tell them from all others.
std::string text_of(const ParameterValue& value);

// What a scene is made from, by its name: a number in a range, one of some words, or any number of numbers in
// a range.
struct Parameter {
  std::string name;
  ParameterValue value;  // the default
  Range range;           // of a number, of each in a list
  std::string meaning;
  std::vector<std::string> choices{};  // of a word
  std::string derived{};               // what a number follows from where this stands for it; empty: nothing

  [[nodiscard]] bool allows(const ParameterValue& given) const;
  // "a number in (0, 2]", "one of a, b", "a finite number, or a*q1"
  [[nodiscard]] std::string allowed() const;
  // A word of the choices, any number, or what it is derived from, or a list of any numbers; an empty text is
  // the empty list. Throws std::invalid_argument naming the parameter, the text and what is allowed.
  [[nodiscard]] ParameterValue read(std::string_view text) const;
};

// A parameter with one of these words; the first is the default.
Parameter choice(std::string name, std::vector<std::string> choices, std::string meaning);

// A number that by default follows from other parameters in the way this formula says.
Parameter derived_number(std::string name, std::string formula, Range range, std::string meaning);

// A parameter that is a list of numbers, each in the range.
Parameter list_of_numbers(std::string name, std::vector<double> numbers, Range range, std::string meaning);

// The parameter of this name. Throws std::invalid_argument where there is none.
const Parameter& parameter_named(std::string_view name, std::string_view scene,
                                 const std::vector<Parameter>& parameters);

// Values of all parameters of one scene.
class Parameters {
 public:
  // The defaults with some values replaced. Throws std::invalid_argument naming the parameter, the value and
  // what is allowed, when a name is unknown or a value is not allowed.
  Parameters(std::string_view scene, const std::vector<Parameter>& parameters, const ParameterValues& values);

  // Each throws std::out_of_range where there is no parameter of this name, and std::bad_variant_access where
  // it is of the other kind.
  double operator[](std::string_view name) const;                                 // a number
  [[nodiscard]] const std::string& choice(std::string_view name) const;           // the word of a choice
  [[nodiscard]] const std::vector<double>& numbers(std::string_view name) const;  // a list

  // A number that may be derived: nothing where it is. Throws std::out_of_range where there is none.
  [[nodiscard]] std::optional<double> given(std::string_view name) const;

  [[nodiscard]] std::string text() const;  // "a=1 b=0.5 c=word", in the order of the alphabet

 private:
  ParameterValues values_;
};

// Throws std::invalid_argument: "NAME = VALUE: must be ALLOWED".
[[noreturn]] void reject(std::string_view name, const ParameterValue& value, std::string_view allowed);

}  // namespace fde
