// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "support/matchers.hpp"    // IWYU pragma: export
#include "support/message_of.hpp"  // IWYU pragma: export

namespace fde::bench {

inline const SceneFactory& scene_factory(std::string_view id) { return *find_scene(id); }

inline Scene scene_of(std::string_view id, const ParameterValues& values = {}) {
  return make_scene(scene_factory(id), values);
}

inline Trajectory solve(std::string_view scheme, const Problem& problem, const Resolution& resolution,
                        const Options& options = {}) {
  return find_scheme(scheme)->solve(problem, resolution, options);
}
inline Trajectory solve(std::string_view scheme, const Problem& problem, int steps,
                        const Options& options = {}) {
  return solve(scheme, problem, Grid{problem.end, steps}, options);
}

// The difference that rounding may cause between two computations of the same result: starting weights may
// amplify it.
inline double rounding_allowance(const Scheme& scheme, double plain) {
  constexpr double unit = 1e-16;
  return scheme.starting_powers ? std::max(plain, unit * max_growth) : plain;
}

// Names of parameterised tests: the id of the scheme or scene, the name of a case, a text.
inline constexpr auto id_of_param = [](const auto& test) { return std::string(test.param->id); };
inline constexpr auto name_of_param = [](const auto& test) { return std::string(test.param.name); };
inline constexpr auto text_of_param = [](const auto& test) { return std::string(test.param); };

// A text with _ in place of what no name of a test has.
inline std::string as_identifier(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

inline std::vector<const Scheme*> all_schemes() {
  std::vector<const Scheme*> all;
  for (const auto& scheme : schemes()) all.push_back(&scheme);
  return all;
}

// The schemes that use a grid and have a theoretical rate.
inline std::vector<const Scheme*> grid_schemes() {
  auto some = all_schemes();
  std::erase_if(some, [](const Scheme* scheme) {
    return scheme->capabilities.is_adaptive() || !scheme->expected_rate;
  });
  return some;
}

// Of the grid schemes, those that discretise the rows of a problem, and those that discretise its equations.
inline std::vector<const Scheme*> row_schemes() {
  auto some = grid_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return scheme->capabilities.discretises_equations; });
  return some;
}
inline std::vector<const Scheme*> equation_schemes() {
  auto some = grid_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->capabilities.discretises_equations; });
  return some;
}

// The schemes with a symbol for the stability on linear problems.
inline std::vector<const Scheme*> schemes_with_symbol() {
  auto some = all_schemes();
  std::erase_if(some, [](const Scheme* scheme) { return !scheme->symbol; });
  return some;
}

}  // namespace fde::bench
