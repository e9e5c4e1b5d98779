// SPDX-License-Identifier: MIT
#pragma once

#include <fdebench.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench::c {

using OptionValue = std::variant<long long, double, std::vector<double>, std::string>;

}  // namespace fde::bench::c

// What the handles of fdebench.h point to.

// `scene` is the text that names a scene; empty for a problem of the caller. `known` has its default form.
struct FdebenchProblem {
  std::string scene{};
  fde::bench::Scene known{};
  void* user = nullptr;  // of its callbacks
};

struct FdebenchOptions {
  std::map<std::string, fde::bench::c::OptionValue> values{};
};

// Values and bounds have one column for each time. Facts are an object of numbers and texts.
struct FdebenchTable {
  std::vector<std::string> names{};
  std::vector<double> times{};
  fde::Matrix values{}, bounds{};
  nlohmann::json facts = nlohmann::json::object();
};

struct FdebenchChoice {
  nlohmann::json facts{};
};

namespace fde::bench::c {

// The values of an option that is set. What is set as a text is parsed, a list of one number is that number.
// Each throws Refusal naming the option, its value and what is allowed.
double real_of(const std::string& name, const OptionValue& value, const Range& allowed);
int count_of(const std::string& name, const OptionValue& value, const CountRange& allowed);
std::vector<double> reals_of(const std::string& name, const OptionValue& value, const Range& allowed);
std::string text_of(const OptionValue& value);

inline constexpr auto problem_handle = "a handle of fdebench_problem_new or fdebench_problem_of_scene";
inline constexpr auto options_handle = "a handle of fdebench_options_new";

// The number or the text of a fact; NaN or "" where it has none. Throws std::invalid_argument naming those
// that there are.
double number_in(const nlohmann::json& facts, const std::string& name);
const char* text_in(const nlohmann::json& facts, const std::string& name);

}  // namespace fde::bench::c
