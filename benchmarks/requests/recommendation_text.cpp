// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/requests/recommendation.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"

namespace fde::bench {
namespace {

// Why the first option is quicker than the second: fewer steps or cheaper steps.
std::string reason_for_speed(const RecommendedRun& first, const RecommendedRun& second,
                             std::string_view error) {
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
  if (second.first_run && second.setup_seconds > second.later_run_seconds()) {
    return fmt::format("its first run takes {} for start weights and tables",
                       time_text(second.setup_seconds));
  }
  count = count.empty() ? "it needs as many steps" : fmt::format("it needs {} steps", count);
  each = each.empty() ? "a step costs the same" : fmt::format("a step costs {}", each);
  return fmt::format("{}{}, {}", count, rates, each);
}

std::string steps_text(const RecommendedRun& option) {
  const auto* accuracy = std::get_if<Tolerance>(&option.settings.resolution);
  if (option.steps == 0) return "";
  return count_text(option.steps) + (accuracy != nullptr ? " to " + error_text(accuracy->rtol) : "");
}

TableRow row_of(const RecommendedRun& option, std::string outcome) {
  const auto seconds = [&](double value) { return value > 0.0 ? time_text(value) : std::string(); };
  return {fmt::format("{}", fmt::join(option.schemes, " = ")),
          option.settings.grading == 1.0 ? "" : grid_text(option.settings.grading),
          steps_text(option),
          option.steps > 0 && std::isfinite(option.error) ? error_text(option.error) : "",
          seconds(option.later_run_seconds()) + std::string(clock_note(option.wall_clock)),
          option.wall_clock ? "" : seconds(option.first_run_seconds()),
          std::move(outcome)};
}

// Of each scheme the best grid; with `verbose` all.
std::string table_of(const Recommendation& made, bool verbose) {
  std::vector<TableRow> rows{
      {"scheme", "grid", "N", std::string(error_word(made)), "time", "first run", "against the best"}};
  std::set<std::string> listed;
  const double least = made.options.front().time.median;
  for (const RecommendedRun& option : made.options) {
    if (!listed.insert(option.schemes.front()).second && !verbose) continue;
    const bool is_best = &option == &made.options.front();
    rows.push_back(
        row_of(option, is_best ? "" : fmt::format("{:.2f} times as long", option.time.median / least)));
  }
  for (const RejectedScheme& scheme : made.rejected) {
    if (scheme.refused && !verbose) continue;
    if (!listed.insert(scheme.finest.schemes.front()).second && !verbose) continue;
    rows.push_back(row_of(scheme.finest, scheme.reason));
  }
  return aligned(rows, 2);
}

// "; residual 1.2e-7, ..." of the measures of the caller.
std::string measured_text(const RecommendedRun& run) {
  std::string text;
  for (const auto& [measure, value] : run.measured)
    text += fmt::format("{}{} {:.3g}", text.empty() ? "; " : ", ", measure, value);
  return text;
}

// "error 8.7e-13 in 9.6 µs; the first run of a process takes 12.3 ms".
std::string delivery(const Recommendation& made, const RecommendedRun& first) {
  const double once = first.first_run_seconds(), later = first.later_run_seconds();
  const auto columns = made.columns.empty() ? "" : fmt::format(", in {}", fmt::join(made.columns, ", "));
  auto text = fmt::format("{} {} ({}{}; {} wanted) in {}{}", error_word(made), error_text(first.error),
                          kind_text(made.kind), columns, error_text(made.accuracy),
                          time_text(first.time.median), clock_note(first.wall_clock));
  if (first.wall_clock) return text;
  if (first.first_run) return text + fmt::format(", the first run of a process; {} later", time_text(later));
  return text + (first.setup_seconds > 0.0
                     ? fmt::format("; {} for the first run of a process", time_text(once))
                     : "; as quick the first time");
}

std::string certainty(const Recommendation& made, const RecommendedRun& first) {
  std::string text;
  if (made.estimate) text = estimate_text(*made.estimate) + "; ";
  if (made.reference_bound && !made.estimate) {
    text = fmt::format("the reference is known to {}{}; ", error_text(*made.reference_bound),
                       made.examined_at_points_only ? ", examined at points only" : "");
  }
  text += fmt::format("the time is in {} ... {} ({:.0f} %)", time_text(first.time.low),
                      time_text(first.time.high), 100.0 * first.time.confidence);
  if (made.constant) return text + "; the solution is constant: any scheme that keeps y(0) will do";
  if (const auto noise = within_noise(made); !noise.empty())
    return text + fmt::format("; within noise of {}", fmt::join(noise, ", "));
  if (const auto* second = runner_up(made)) {
    text += fmt::format("; {} takes {:.2f} times as long", second->schemes.front(),
                        second->time.median / first.time.median);
  }
  return text;
}

// "coarse: the error allowed in x, 0.01, is 2.1 times its largest value, 0.0048; --scale peak ...".
std::string coarseness(const Recommendation& made) {
  std::vector<std::string> columns;
  for (const auto& [name, largest, allowed] : made.small) {
    columns.push_back(fmt::format("in {} {}, {:.2g} times its largest value {}", name, error_text(allowed),
                                  allowed / largest, error_text(largest)));
  }
  return fmt::format("coarse: the error allowed is {}; --scale peak takes errors as parts of that value\n",
                     fmt::join(columns, ", "));
}

}  // namespace

std::string to_text(const Recommendation& made, bool verbose, const Emphasis& emphasis) {
  const RecommendedRun& first = made.options.front();
  const auto command = command_of(made.scene, first);
  const auto run = command.empty() ? fmt::format("{} with N = {}", name_of(first), first.steps) : command;
  std::string text = fmt::format("{}{}\n{} {}\n{} {}\n", emphasis.label("run:"), emphasis.command(" " + run),
                                 emphasis.label("delivers:"), delivery(made, first) + measured_text(first),
                                 emphasis.label("how sure:"), certainty(made, first));
  if (!made.small.empty()) text += coarseness(made);
  if (verbose) {
    if (first.predicted_error)
      text += fmt::format("predicted {} {}\n", error_word(made), error_text(*first.predicted_error));
    if (const auto* second = runner_up(made)) {
      text += fmt::format("why: against {} {}\n", name_of(*second),
                          reason_for_speed(first, *second, error_word(made)));
    }
  }
  return text + '\n' + table_of(made, verbose);
}

}  // namespace fde::bench
