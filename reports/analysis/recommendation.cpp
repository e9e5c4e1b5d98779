// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/recommendation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "fdebench/reports/analysis/text.hpp"

namespace fde::bench {
namespace {

bool same_scheme(const RecommendedRun& a, const RecommendedRun& b) { return a.schemes == b.schemes; }

bool meet(const MedianInterval& a, const MedianInterval& b) { return a.low <= b.high && b.low <= a.high; }

// Why the first option is quicker than the second: fewer steps or cheaper steps.
std::string reason(const RecommendedRun& first, const RecommendedRun& second, std::string_view error) {
  const double steps = static_cast<double>(second.steps) / first.steps,
               cost = first.seconds_per_step() / second.seconds_per_step();
  const auto compared = [](double ratio, const char* more, const char* less) {
    if (ratio > 1.05) return fmt::format("{:.2g} times {}", ratio, more);
    if (ratio < 0.95) return fmt::format("{:.2g} times {}", 1.0 / ratio, less);
    return std::string();
  };
  std::string count = compared(steps, "fewer", "more"), each = compared(cost, "as much", "less");
  std::string rates;
  if (first.rate && second.rate)
    rates = fmt::format(" (its {} falls with rate {:.2f}, there {:.2f})", error, *first.rate, *second.rate);
  count = count.empty() ? "it needs as many steps" : fmt::format("it needs {} steps", count);
  each = each.empty() ? "a step costs the same" : fmt::format("a step costs {}", each);
  return fmt::format("{}{}, {}", count, rates, each);
}

std::string expected_text(const RecommendedRun& option) {
  return fmt::format("expected {} ({} ... {}) with about N = {}", time_text(option.time.median),
                     time_text(option.time.low), time_text(option.time.high), rough_count_text(option.steps));
}

std::string way_text(const Configuration& configuration, int steps) {
  const auto grid = configuration.grading == 1.0 ? "" : ", " + grid_text(configuration.grading);
  return fmt::format("{}{} with N = {}", configuration.scheme->id, grid, count_text(steps));
}

// The lines after the first option.
std::string comparison(const Recommendation& made) {
  const RecommendedRun& first = made.options.front();
  std::string text;
  if (const auto noise = within_noise(made); !noise.empty())
    text += fmt::format("within noise of {}\n", fmt::join(noise, ", "));
  if (const auto* second = runner_up(made))
    text += fmt::format("why: against {} {}\n", name_of(*second), reason(first, *second, error_word(made)));
  const auto times_as_long = [&](const RecommendedRun& option) {
    return fmt::format("{:.2f} times as long", option.time.median / first.time.median);
  };
  for (const RecommendedRun& option : made.options) {
    if (&option == &first) continue;
    text += fmt::format("{}: {}, {}\n", name_of(option), run_text(option, error_word(made)),
                        times_as_long(option));
  }
  for (const RecommendedRun& option : made.expected)
    text += fmt::format("{}: {}, {}\n", name_of(option), expected_text(option), times_as_long(option));
  return text;
}

}  // namespace

std::string_view error_word(const Recommendation& made) {
  return made.estimate ? "estimated error" : "error";
}

std::vector<std::string> within_noise(const Recommendation& made) {
  std::vector<std::string> names;
  const RecommendedRun& first = made.options.front();
  for (const RecommendedRun& option : made.options) {
    if (same_scheme(option, first) || !meet(option.time, first.time)) continue;
    if (std::ranges::find(names, option.schemes.front()) == names.end())
      names.push_back(option.schemes.front());
  }
  return names;
}

const RecommendedRun* runner_up(const Recommendation& made) {
  const auto is_other = [&](const RecommendedRun& option) {
    return !same_scheme(option, made.options.front());
  };
  const auto found = std::ranges::find_if(made.options, is_other);
  if (found != made.options.end()) return &*found;
  return made.expected.empty() ? nullptr : &made.expected.front();
}

std::string options_of(const RecommendedRun& option) {
  if (option.external) return "";
  const auto* accuracy = std::get_if<Tolerance>(&option.setup.resolution);
  auto options = accuracy != nullptr ? fmt::format("--accuracy {}", accuracy->rtol)
                                     : fmt::format("--steps {}", option.steps);
  if (option.setup.grading != 1.0) options += fmt::format(" --grid {}", grid_text(option.setup.grading));
  if (option.setup.history != HistoryKind::automatic)
    options += fmt::format(" --history {}", name(option.setup.history));
  if (option.setup.tolerance != RunSettings().tolerance)
    options += fmt::format(" --tolerance {}", option.setup.tolerance);
  return options;
}

std::string command_of(const SceneSettings& scene, const RecommendedRun& option) {
  if (option.external) return "";
  return fmt::format("fdebench solve {} --scheme {} {}", label_of(scene), option.schemes.front(),
                     options_of(option));
}

std::string estimate_text(const ErrorEstimate& estimate) {
  return fmt::format(
      "errors are estimated, not verified: there is no reference ({}); in its place {} is used, which {} "
      "differs from by {}, so it is taken to be off by {}, which counts as error",
      estimate.no_reference_reason, way_text(estimate.first, estimate.first_steps),
      way_text(estimate.second, estimate.second_steps), error_text(estimate.difference),
      error_text(estimate.error()));
}

std::string kind_text(const ErrorKind& kind) {
  const auto* where = kind.norm == Norm::end ? "at the end" : "maximum over all steps";
  return fmt::format("{}, {} scale", where, name(kind.scale));
}

std::string name_of(const RecommendedRun& option) {
  std::string text = fmt::format("{}", fmt::join(option.schemes, " = "));
  if (option.setup.grading != 1.0) text += ", " + grid_text(option.setup.grading);
  return text;
}

std::string to_text(const Recommendation& made) {
  const RecommendedRun& first = made.options.front();
  std::string text =
      fmt::format("{} to {} ({})\n", label_of(made.scene), error_text(made.accuracy), kind_text(made.kind));
  text += fmt::format("{}: {}\n", name_of(first), run_text(first, error_word(made)));
  if (first.predicted_error)
    text += fmt::format("predicted {} {}\n", error_word(made), error_text(*first.predicted_error));
  if (made.estimate) text += estimate_text(*made.estimate) + "\n";
  text += made.constant ? "the solution is constant: any scheme that keeps its initial value will do\n"
                        : comparison(made);
  for (const auto& other : made.others) text += other + "\n";
  return first.external ? text : text + fmt::format("again: {}\n", command_of(made.scene, first));
}

}  // namespace fde::bench
