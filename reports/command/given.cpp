// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/given.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::bench {

Given::Given(SubcommandText command, Texts texts) : command_(std::move(command)), texts_(std::move(texts)) {}

const ArgumentText& Given::declared(std::string_view name) const {
  if (const auto* argument = command_.find(name)) return *argument;
  throw std::logic_error(fmt::format("{} does not declare {}", command_.name, name));
}

bool Given::has(std::string_view name) const { return texts_.find(declared(name).name) != texts_.end(); }

std::optional<std::string> Given::find(std::string_view name) const {
  return has(name) ? std::optional(all(name).back()) : std::nullopt;
}

std::string Given::text(std::string_view name) const { return find(name).value_or(declared(name).usual); }

const std::vector<std::string>& Given::all(std::string_view name) const {
  static const std::vector<std::string> none;
  return has(name) ? texts_.find(name)->second : none;
}

double Given::number(std::string_view name) const {
  return parse_number(name, text(name), std::get<Range>(declared(name).allowed));
}

std::optional<double> Given::find_number(std::string_view name) const {
  return has(name) ? std::optional(number(name)) : std::nullopt;
}

std::vector<double> Given::numbers(std::string_view name) const {
  return parse_numbers(name, text(name), std::get<Range>(declared(name).allowed));
}

int Given::count(std::string_view name) const {
  const auto& [lowest, highest] = std::get<CountRange>(declared(name).allowed);
  return parse_count(name, text(name), lowest, highest);
}

std::optional<int> Given::find_count(std::string_view name) const {
  return has(name) ? std::optional(count(name)) : std::nullopt;
}

std::string Given::word(std::string_view name) const {
  const auto& words = std::get<Words>(declared(name).allowed);
  if (std::ranges::find(words, text(name)) == words.end()) refuse(name, choice_text(words));
  return text(name);
}

void Given::refuse(const std::string& message) const {
  throw std::invalid_argument(fmt::format("{}; see fdebench {} --help", message, command_.name));
}

void Given::refuse(std::string_view name, std::string_view allowed) const {
  reject_text(name, text(name), allowed);
}

void Given::refuse(const Refusal& refusal, const std::map<std::string, std::string>& words) const {
  throw refusal.said([&](const std::string& field) {
    if (const auto word = words.find(field); word != words.end()) return word->second;
    const auto option = "--" + field;
    return command_.find(option) != nullptr ? option : field;
  });
}

ArgumentText scene_argument(const std::string& what) {
  return {"SCENE", what + " or an equation file, or ID:NAME=VALUE,...", Completion::scene};
}

ArgumentText set_argument() {
  return {"[--set NAME=VALUE]...", "a parameter of the scene, or its end: until=T", Completion::setting};
}

std::vector<ArgumentText> run_settings_arguments(const std::string& budget) {
  return {{"[--grid GRID]", "where the times of the steps are; graded:auto takes R from the orders",
           Completion::grid, uniform_grid},
          {"[--history KIND]", "how the sums over earlier steps are computed",
           Words{std::string(name(HistoryKind::automatic)), std::string(name(HistoryKind::direct)),
                 std::string(name(HistoryKind::exponentials))},
           std::string(name(HistoryKind::automatic))},
          {"[--tolerance E]",
           "relative error of Newton's method and of the history, added to the discretisation error",
           newton_tolerances, "rounding"},
          {"[--budget SECONDS]", "time after which the run ends", positive, budget}};
}

ArgumentText digits_argument() {
  return {"[--digits D]", "number of decimal digits", CountRange{1, reference::max_digits}, "double"};
}

ArgumentText evaluation_budget_argument() {
  return {"[--budget SECONDS]", "time after which the evaluation ends", positive, "none"};
}

ArgumentText plain_names_argument() {
  return {"[--plain-names]", "name columns without commas and parentheses, Dx_0.6 in place of D(x,0.6)"};
}

ArgumentText runs_argument() {
  return {"[--runs RUNS]", "rank by the time of the first run of a process (1) or of a later one",
          Words{"1", "many"}, "many"};
}

ArgumentText until_argument() {
  return {"[--until T]", "end of the time interval", valid_end_times, "that of the scene"};
}

std::vector<ArgumentText> joined(std::initializer_list<std::vector<ArgumentText>> lists) {
  std::vector<ArgumentText> all;
  for (const auto& list : lists) std::ranges::copy(list, std::back_inserter(all));
  return all;
}

SceneVariant read_variant(const Given& given, const SceneRegistry& known) {
  return read_variant(given.text("scene"), given.all("--set"), known);
}

void refuse_overwriting(const Given& given, std::string_view out,
                        std::initializer_list<std::string_view> read) {
  const auto written = given.find(out);
  if (!written) return;
  for (const auto name : read) {
    for (const std::string& text : given.all(name)) {
      constexpr std::string_view end = ".toml";  // settings of a scene follow it
      const auto at = name == "scene" ? text.find(end) : std::string::npos;
      const auto file = at == std::string::npos ? text : text.substr(0, at + end.size());
      if (is_same_file(*written, file))
        given.refuse(out, fmt::format("another file than {}, which is read", text));
    }
  }
}

Tolerance parse_accuracy(std::string_view text) {
  const double error = parse_number("--accuracy", text, positive);
  return {.rtol = error, .atol = error};
}

bool requests_first_run(const Given& given) { return given.word("--runs") == "1"; }

RunSettings parse_run_settings(const Given& given) {
  RunSettings settings;
  try {
    settings.grading = parse_grid(given.text("--grid")).value_or(1.0);
    settings.history = parse_history(given.text("--history"));
  } catch (const Refusal& refusal) {
    given.refuse(refusal);
  }
  if (const auto tolerance = given.find_number("--tolerance")) settings.newton_tolerance = *tolerance;
  // The default of a sweep is no number: it depends on other options.
  if (given.has("--budget") || is_decimal(given.text("--budget"))) settings.budget = given.number("--budget");
  return settings;
}

}  // namespace fde::bench
