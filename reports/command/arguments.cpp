// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

constexpr Range tolerances{.low = 0.0, .high = 1.0};

}  // namespace

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
  command.required("scene", arguments.scene, what + " or an equation file, or ID:NAME=VALUE,...")
      .completed_by(Completion::scene);
  command.list("--set", arguments.settings, "a parameter of the scene, or its end: until=T")
      .takes("NAME=VALUE")
      .completed_by(Completion::setting);
}

SceneVariant read_variant(const SceneArguments& arguments, const SceneRegistry& known) {
  return read_variant(arguments.scene, arguments.settings, known);
}

std::vector<Argument> add_options(Subcommand& command, RunSettingsArguments& arguments) {
  const auto grid = command
                        .option("--grid", arguments.grid,
                                "where the times of the steps are; graded:auto takes R from the orders")
                        .takes("GRID", "uniform or graded:R with R in [1, 100], or graded:auto")
                        .offers({"uniform", "graded:", "graded:auto"})
                        .usual(arguments.grid);
  const auto history =
      command.option("--history", arguments.history, "how the sums over earlier steps are computed")
          .takes("KIND",
                 Words{std::string(name(HistoryKind::automatic)), std::string(name(HistoryKind::direct)),
                       std::string(name(HistoryKind::exponentials))})
          .usual(arguments.history);
  const auto tolerance =
      command
          .option("--tolerance", arguments.tolerance,
                  "relative error of Newton's method and of the history, added to the discretisation error")
          .takes("E", tolerances)
          .usual("rounding");
  const auto budget = command.option("--budget", arguments.budget, "time after which the run ends")
                          .takes("SECONDS", positive, "seconds")
                          .usual(arguments.budget_text.empty() ? arguments.budget : arguments.budget_text);
  return {grid, history, tolerance, budget};
}

Argument add_digits(Subcommand& command, std::optional<std::string>& digits) {
  return command.option("--digits", digits, "number of decimal digits")
      .takes("D", digit_counts)
      .usual("double");
}

Argument add_evaluation_budget(Subcommand& command, std::optional<std::string>& budget) {
  return command.option("--budget", budget, "time after which the evaluation ends")
      .takes("SECONDS", positive, "seconds")
      .usual("none");
}

Argument add_runs(Subcommand& command, std::string& runs) {
  return command
      .option("--runs", runs, "rank by the time of the first run of a process (1) or of a later one")
      .takes("RUNS", run_words())
      .usual(runs);
}

Argument add_until(Subcommand& command, std::optional<std::string>& until) {
  return command.option("--until", until, "end of the time interval")
      .takes("T", valid_end_times)
      .usual("that of the scene");
}

int parse_count(std::string_view name, std::string_view text, const CountRange& allowed) {
  return parse_count(name, text, allowed.lowest, allowed.highest);
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

const Words& run_words() {
  static const Words words{"1", "many"};
  return words;
}

bool requests_first_run(const std::string& runs) {
  const auto& words = run_words();
  if (std::ranges::find(words, runs) == words.end()) reject_text("--runs", runs, choice_text(words));
  return runs == words.front();
}

bool requests_optimal_grading(const RunSettingsArguments& arguments) {
  return arguments.grid == "graded:auto";
}

namespace {

// Parses a setting that files have too; the message names it as the option, and what the option takes
// besides.
template <class Parse>
auto of_option(const std::string& text, const Parse& parse, std::string_view more = "") {
  try {
    return parse(text);
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(fmt::format("--{}{}", fault.what(), more));
  }
}

}  // namespace

RunSettings parse_run_settings(const RunSettingsArguments& arguments) {
  const double grading = requests_optimal_grading(arguments)
                             ? 1.0
                             : of_option(arguments.grid, parse_grading, ", or graded:auto");
  RunSettings setup{.grading = grading, .history = of_option(arguments.history, parse_history)};
  if (arguments.tolerance) setup.tolerance = parse_number("--tolerance", *arguments.tolerance, tolerances);
  setup.budget = parse_number("--budget", arguments.budget, positive);
  return setup;
}

}  // namespace fde::bench
