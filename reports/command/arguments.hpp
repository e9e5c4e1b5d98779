// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/count_range.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reports/command/command_line.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// Parsers of command-line arguments. Each throws std::invalid_argument naming the argument, the text and what
// is allowed.

// Splits "1", "1,2", "-2.5i", "1e-3+i" into the texts of real and imaginary part; the parts are not
// validated.
struct ComplexText {
  std::string re, im;
};
ComplexText split_complex(std::string_view text);

// The scheme with this id.
const Scheme& scheme_named(std::string_view id);

// The scene of a command, SCENE or SCENE:NAME=VALUE,..., and the texts of --set.
struct SceneArguments {
  std::string scene;
  std::vector<std::string> settings;
};
void add_scene(Subcommand& command, SceneArguments& arguments, const std::string& what = "id of a scene");
SceneVariant read_variant(const SceneArguments& arguments, const SceneRegistry& known);

// Options of `solve` and `run` that set how a scheme runs. A budget that depends on other options has a text.
struct RunSettingsArguments {
  std::string grid = "uniform", history = "auto", budget, budget_text{};
  std::optional<std::string> tolerance{};
};
std::vector<Argument> add_options(Subcommand& command, RunSettingsArguments& arguments);
// For --grid graded:auto the grading is 1 here: it depends on scheme and scene (optimal_grading).
RunSettings parse_run_settings(const RunSettingsArguments& arguments);
bool requests_optimal_grading(const RunSettingsArguments& arguments);

// Throws if the text is no decimal number; its value may exceed the range of double.
void require_decimal(std::string_view name, std::string_view text);

// The seconds of --budget; nullopt if it is not given.
std::optional<double> parse_budget(const std::optional<std::string>& text);

// Times >= 0, sorted, without repetitions: "2,1,2" gives 1, 2.
std::vector<double> sorted_times(std::string_view name, std::string_view text);

Tolerance parse_accuracy(std::string_view text);  // one number, relative and absolute

// Whether times are those of the first run of a process: --runs 1, otherwise many.
bool requests_first_run(const std::string& runs);

// What --runs may be.
const Words& run_words();

inline constexpr CountRange digit_counts{1, reference::max_digits};
inline constexpr int most_steps = 1'000'000'000;  // the weights are tested up to this lag
inline constexpr CountRange step_counts{1, most_steps};
int parse_count(std::string_view name, std::string_view text, const CountRange& allowed);

// Options of several commands.
Argument add_digits(Subcommand& command, std::optional<std::string>& digits);
Argument add_evaluation_budget(Subcommand& command, std::optional<std::string>& budget);
Argument add_runs(Subcommand& command, std::string& runs);
Argument add_until(Subcommand& command, std::optional<std::string>& until);

}  // namespace fde::bench
