// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/recommended_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <variant>

#include "fdebench/benchmarks/requests/own_problem.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {

std::string options_of(const RunSettings& settings, int steps) {
  const auto* accuracy = std::get_if<Tolerance>(&settings.resolution);
  auto options =
      accuracy != nullptr ? fmt::format("--accuracy {}", accuracy->rtol) : fmt::format("--steps {}", steps);
  if (settings.grading != 1.0) options += fmt::format(" --grid {}", grid_text(settings.grading));
  if (settings.history != HistoryKind::automatic)
    options += fmt::format(" --history {}", name(settings.history));
  if (settings.newton_tolerance != RunSettings().newton_tolerance)
    options += fmt::format(" --tolerance {}", settings.newton_tolerance);
  return options;
}

std::string options_of(const RecommendedRun& option) {
  return option.external ? "" : options_of(option.settings, option.steps);
}

std::string command_of(const SceneSettings& scene, const RecommendedRun& option) {
  if (option.external || scene.id == own_id) return "";
  return fmt::format("fdebench solve {} --scheme {} {}", shell_word(label_of(scene)), option.schemes.front(),
                     options_of(option));
}

std::string name_of(const RecommendedRun& option) {
  std::string text = fmt::format("{}", fmt::join(option.schemes, " = "));
  if (option.settings.grading != 1.0) text += ", " + grid_text(option.settings.grading);
  return text;
}

std::string run_text(const RecommendedRun& option, std::string_view error) {
  const auto* accuracy = std::get_if<Tolerance>(&option.settings.resolution);
  const auto requested = accuracy != nullptr ? fmt::format("accuracy {}, ", error_text(accuracy->rtol)) : "";
  std::string text =
      fmt::format("{}N = {}, {} {}", requested, count_text(option.steps), error, error_text(option.error));
  if (!(option.time.median > 0.0)) return text + ", not timed";
  const auto& [median, low, high, confidence] = option.time;
  text += fmt::format(", {} ({} ... {}){}", time_text(median), time_text(low), time_text(high),
                      clock_note(option.wall_clock));
  return text;
}

std::string needed_text(const std::string& name, const Prediction& steps) {
  return fmt::format("{} would need about N = {} ({} ... {}), by its errors so far", name,
                     rough_count_text(steps.value), rough_count_text(steps.low),
                     rough_count_text(steps.high));
}

}  // namespace fde::bench
