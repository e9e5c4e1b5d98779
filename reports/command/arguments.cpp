// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {

ComplexText split_complex(std::string_view text) {
  const auto comma = text.find(',');
  if (comma != std::string_view::npos)
    return {std::string(text.substr(0, comma)), std::string(text.substr(comma + 1))};
  if (!text.ends_with('i')) return {std::string(text), "0"};
  text.remove_suffix(1);
  // The last sign that does not belong to an exponent separates the parts.
  auto sign = text.find_last_of("+-");
  while (sign != std::string_view::npos && sign > 0 && (text[sign - 1] == 'e' || text[sign - 1] == 'E'))
    sign = text.find_last_of("+-", sign - 1);
  const std::size_t begin = sign == std::string_view::npos ? 0 : sign;
  std::string im(text.substr(begin));
  if (im.empty() || im == "+" || im == "-") im += "1";
  return {begin == 0 ? "0" : std::string(text.substr(0, begin)), im};
}

const Scheme& scheme_named(std::string_view id) {
  const Scheme* const found = find_scheme(id);
  return found != nullptr ? *found : entry_by_id(schemes(), "scheme", id);
}

void add_scene(Subcommand& command, SceneArguments& arguments, const std::string& what) {
  command.required("scene", arguments.scene, what + " or file of equations, or ID:NAME=VALUE,...");
  command.list("--set", arguments.settings, "a parameter of the scene, NAME=VALUE");
}

SceneVariant read_variant(const SceneArguments& arguments, const SceneRegistry& known) {
  return read_variant(arguments.scene, arguments.settings, known);
}

void add_options(Subcommand& command, RunSettingsArguments& arguments) {
  command.option("--grid", arguments.grid, "uniform, graded:R, or graded:auto: R from the orders");
  command.option("--history", arguments.history, "auto, direct or exponentials");
  command.option("--tolerance", arguments.tolerance,
                 "relative, of Newton's method and of the history weights; default rounding");
  command.option("--budget", arguments.budget,
                 fmt::format("seconds after which the run ends; default {}", arguments.budget));
}

void require_decimal(std::string_view name, std::string_view text) {
  if (!is_decimal(text)) reject_text(name, text, any_number.text());
}

std::optional<double> parse_budget(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  return parse_number("--budget", *text, positive);
}

std::vector<double> sorted_times(std::string_view name, std::string_view text) {
  auto times = parse_numbers(name, text, not_negative);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Tolerance parse_accuracy(std::string_view text) {
  const double error = parse_number("--accuracy", text, positive);
  return {.rtol = error, .atol = error};
}

bool requests_first_run(const std::string& runs) {
  if (runs != "1" && runs != "many") reject_text("--runs", runs, "1 or many");
  return runs == "1";
}

bool requests_optimal_grading(const RunSettingsArguments& arguments) {
  return arguments.grid == "graded:auto";
}

RunSettings parse_run_settings(const RunSettingsArguments& arguments) {
  const double grading = requests_optimal_grading(arguments) ? 1.0 : parse_grading(arguments.grid);
  RunSettings setup{.grading = grading, .history = parse_history(arguments.history)};
  if (arguments.tolerance)
    setup.tolerance = parse_number("--tolerance", *arguments.tolerance, {.low = 0.0, .high = 1.0});
  setup.budget = parse_number("--budget", arguments.budget, positive);
  return setup;
}

}  // namespace fde::bench
