#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fde {

// An interval of allowed values. An open end is not allowed itself.
struct Range {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool open_low = false;
  bool open_high = false;

  [[nodiscard]] bool contains(double value) const;  // false for nan
  [[nodiscard]] std::string text() const;           // "a number in (0, 2]"
};

constexpr Range any_number{};
constexpr Range positive{.low = 0.0, .open_low = true};
constexpr Range not_negative{.low = 0.0};
constexpr Range order_up_to_one{.low = 0.0, .high = 1.0, .open_low = true};
constexpr Range order_up_to_two{.low = 0.0, .high = 2.0, .open_low = true};

// A named number that a scene is made from, or a choice: the number is the place of its name among them.
struct Parameter {
  std::string_view name;
  double value;  // the default
  Range range;
  std::string_view meaning;
  std::vector<std::string_view> choices{};

  [[nodiscard]] std::string allowed() const;               // "a number in (0, 2]", "one of a, b"
  [[nodiscard]] std::string text_of(double number) const;  // a choice by its name
  // Throws std::invalid_argument naming the parameter, the text and what is allowed.
  [[nodiscard]] double read(std::string_view text) const;
};

// A parameter with one of these values; the first is the default.
Parameter choice(std::string_view name, std::vector<std::string_view> choices, std::string_view meaning);

// Values of all parameters of one scene.
class Parameters {
 public:
  // The defaults with some values replaced. Throws std::invalid_argument naming the parameter, the value and
  // what is allowed, when a name is unknown or a value out of range.
  Parameters(std::string_view scene, const std::vector<Parameter>& parameters,
             const std::map<std::string, double>& values);

  double operator[](std::string_view name) const { return values_.find(name)->second; }
  [[nodiscard]] std::size_t choice(std::string_view name) const {
    return static_cast<std::size_t>((*this)[name]);
  }

  [[nodiscard]] std::string text() const;  // "a=1 b=0.5", in the order of the alphabet

 private:
  std::map<std::string, double, std::less<>> values_;
};

// Throws std::invalid_argument: "NAME = VALUE: must be ALLOWED".
[[noreturn]] void reject(std::string_view name, double value, std::string_view allowed);

// The parameter of this name. Throws std::invalid_argument where there is none.
const Parameter& parameter_named(std::string_view name, std::string_view scene,
                                 const std::vector<Parameter>& parameters);

// ", did you mean 'x'?" with the candidate of least edit distance to the name.
std::string nearest(std::string_view name, const std::vector<std::string_view>& candidates);

// Throws std::invalid_argument: "KIND ID: no such KIND, did you mean 'X'?; there are ...".
[[noreturn]] void no_such(std::string_view kind, std::string_view id,
                          const std::vector<std::string_view>& ids);

// The entry of this id. Throws std::invalid_argument naming the kind, the id and the ids that there are.
template <typename Entries>
const auto& entry_named(const Entries& entries, std::string_view kind, std::string_view id) {
  std::vector<std::string_view> ids;
  for (const auto& entry : entries) {
    if (entry.id == id) return entry;
    ids.push_back(entry.id);
  }
  no_such(kind, id, ids);
}

}  // namespace fde
