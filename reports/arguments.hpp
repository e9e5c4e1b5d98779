#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "parameters.hpp"
#include "scene.hpp"
#include "scheme.hpp"
#include "sweep.hpp"

namespace fde {

// Texts of the command line into values. Each throws std::invalid_argument naming the argument, the text and
// what is allowed.

double parse_number(std::string_view name, std::string_view text, const Range& allowed);
int parse_count(std::string_view name, std::string_view text, int lowest, int highest);

// "1,2,5" into its numbers.
std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed);
std::vector<std::string> split_list(std::string_view text);

// "1", "-2.5i", "1e-3+i" into the texts of real and imaginary part; the parts are not checked.
struct ComplexText {
  std::string re, im;
};
ComplexText split_complex(std::string_view text);

// NAME=VALUE texts, for this scene.
std::map<std::string, double> parse_settings(const SceneMaker& maker,
                                             const std::vector<std::string>& settings);

// "uniform" or "graded:R", R >= 1.
Grid parse_grid(std::string_view text, double end, int steps);

const SceneMaker& scene_named(std::string_view id);

// "pendulum" or "pendulum:alpha=1.9,beta=0.1", "pendulum:beta=0.1,until=100" with another end.
SceneVariant parse_variant(const std::string& text);

// All scenes, and some with orders that change the answer: a small one, one above 1, a solution that starts
// like a root, and pendulums whose commensurate expansion has many states.
std::vector<SceneVariant> default_scenes();

// What a sweep takes: the default scenes, and some mechanical ones in all formulations that are well posed
// for them. These share a solution and differ in what they do to the constraint.
std::vector<SceneVariant> sweep_scenes();

const Scheme& scheme_named(std::string_view id);

// Ends of time intervals: their products with a number of steps are doubles.
inline constexpr Range any_end{.low = 0.0, .high = 1e290, .open_low = true};
inline constexpr int most_digits = 100'000;
inline constexpr int most_steps = 1'000'000'000;  // weights are checked up to this lag

}  // namespace fde
