// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/requested_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

constexpr int most_direct_steps = 1 << 21;  // more steps take hours

constexpr double rounding = 1e-12;

RunSettings parse_setup(const RunArguments& arguments) {
  StepsOrTolerance resolution;
  if (arguments.accuracy) {
    resolution = parse_accuracy(*arguments.accuracy);
    if (arguments.settings.grid != RunSettingsArguments{}.grid)
      reject_text("--grid", arguments.settings.grid, "without --accuracy, whose schemes choose their times");
  } else {
    resolution = parse_count("--steps", *arguments.steps, step_counts);
  }
  RunSettings setup = parse_run_settings(arguments.settings);
  setup.resolution = resolution;
  return setup;
}

// Throws std::invalid_argument if direct sums would take hours.
void require_affordable(const Grid& grid, HistoryKind history) {
  if (history == HistoryKind::direct && grid.steps > most_direct_steps) {
    throw std::invalid_argument(
        fmt::format("--history = direct: takes up to {} steps, its work grows with their square, not {}",
                    most_direct_steps, grid.steps));
  }
}

// The grid time that equals t up to rounding. Throws std::invalid_argument naming the neighbours if t is not
// a grid time.
double time_at(const Grid& grid, double t) {
  const int nearest = grid.nearest_index(t);
  if (std::abs(grid.time(nearest) - t) <= rounding * t) return grid.time(nearest);
  const int below = std::clamp(grid.time(nearest) < t ? nearest : nearest - 1, 0, grid.steps - 1);
  reject("--at", t,
         fmt::format("a time of the grid: its neighbours are {:.17g} and {:.17g}", grid.time(below),
                     grid.time(below + 1)));
}

std::vector<double> parse_times(const std::string& text, const Resolution& resolution, double end) {
  const auto* grid = std::get_if<Grid>(&resolution);
  std::vector<double> times;
  for (const double t : parse_numbers("--at", text, not_negative)) {
    if (t > end * (1 + rounding)) reject("--at", t, fmt::format("in [0, {}], the times of the run", end));
    times.push_back(grid != nullptr ? time_at(*grid, t) : t);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// The grid times of --every K (every K-th and the last) or --points K (K times from 0 to the end, equally
// spaced in the step number).
std::vector<double> spread_times(const RunArguments& arguments, const Grid& grid) {
  int count = 0;
  double stride = 0.0;
  if (arguments.every) {
    const int fewest = grid.steps / most_rows + 1;
    const int each = parse_count("--every", *arguments.every, fewest, most_steps);
    count = 1 + (grid.steps - 1) / each + 1;
    stride = each;
  } else {
    count = parse_count("--points", *arguments.points, point_counts);
    stride = static_cast<double>(grid.steps) / (count - 1);
  }
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
    times.push_back(grid.time(std::min(grid.steps, static_cast<int>(std::lround(i * stride)))));
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// `count` equally spaced times from 0 to the end.
std::vector<double> spread_times(int count, double end) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(i == count - 1 ? end : end * i / (count - 1));
  return times;
}

// The output times; empty: all.
std::vector<double> times_of(const RunArguments& arguments, const Resolution& resolution, double end) {
  const std::array given{arguments.at.has_value(), arguments.every.has_value(), arguments.points.has_value()};
  if (std::ranges::count(given, true) > 1)
    throw std::invalid_argument("--at, --every and --points: one of them at most");
  if (arguments.at) return parse_times(*arguments.at, resolution, end);
  const auto* grid = std::get_if<Grid>(&resolution);
  if (arguments.every || arguments.points) {
    if (grid != nullptr) return spread_times(arguments, *grid);
    if (arguments.every) {
      reject_text("--every", *arguments.every,
                  "with --steps; with --accuracy --points K prints K equal times");
    }
    return spread_times(parse_count("--points", *arguments.points, point_counts), end);
  }
  if (grid != nullptr && grid->steps > most_rows) {
    throw std::invalid_argument(
        fmt::format("--at, --every or --points is needed beyond {} steps, not all {} are printed", most_rows,
                    grid->steps));
  }
  return {};
}

std::optional<Grid> grid_of(const Resolution& resolution) {
  const auto* grid = std::get_if<Grid>(&resolution);
  return grid == nullptr ? std::nullopt : std::optional(*grid);
}

// Throws std::invalid_argument if --events is given and the run or the scene has no events.
void require_events(const Scene& scene, const RunArguments& arguments) {
  if (!arguments.events) return;
  if (!arguments.accuracy) throw std::invalid_argument("--events: is only taken with --accuracy");
  if (arguments.at || arguments.points)
    throw std::invalid_argument("--events: is not taken with --at and --points");
  if (scene.events.empty())
    throw std::invalid_argument("--events: the scene has none; a file declares them under [event.NAME]");
}

// Throws std::invalid_argument if --field is given with more than 2e8 values, or with an option that excludes
// it.
void require_field(const Scene& scene, const RunArguments& arguments, const std::vector<double>& times,
                   const std::optional<Grid>& grid) {
  if (!arguments.field) return;
  constexpr double most_values = 2e8;
  if (arguments.checkpoint) reject_text("--field", *arguments.field, "without --checkpoint");
  if (arguments.events) reject_text("--field", *arguments.field, "without --events");
  const double rows = times.empty() && grid ? grid->steps + 1.0 : static_cast<double>(times.size());
  const double values = rows * static_cast<double>(scene.problem.size());
  if (values <= most_values) return;
  reject_text("--field", *arguments.field,
              fmt::format("of at most {:g} values, not {:g}: --at, --every and --points choose times",
                          most_values, values));
}

// Throws std::invalid_argument if --all is given for an initial value problem, or with an option that
// excludes it.
void require_several(const Scene& scene, const RunArguments& arguments) {
  if (!arguments.all) return;
  if (!is_two_sided(scene.problem))
    throw std::invalid_argument("--all: is only taken of problems at both ends");
  if (arguments.field) reject_text("--field", *arguments.field, "without --all");
  if (arguments.check) throw std::invalid_argument("--all: is not taken with --check");
}

}  // namespace

RunArguments run_arguments(const std::string& scheme, const std::map<std::string, std::string>& texts) {
  auto others = texts;
  RunArguments arguments;
  arguments.scheme = scheme;
  std::string check = "0";
  std::vector<std::string_view> names;
  const auto take = [&](const char* name, auto& into) {
    names.emplace_back(name);
    if (auto given = others.extract(name)) into = std::move(given.mapped());
  };
  take("accuracy", arguments.accuracy);
  take("at", arguments.at);
  take("budget", arguments.settings.budget);
  take("check", check);
  take("every", arguments.every);
  take("grid", arguments.settings.grid);
  take("history", arguments.settings.history);
  take("points", arguments.points);
  take("steps", arguments.steps);
  take("threads", arguments.threads);
  take("tolerance", arguments.settings.tolerance);
  if (!others.empty())
    reject_text("option", others.begin()->first, fmt::format("of {}", fmt::join(names, ", ")));
  arguments.check = parse_count("--check", check, 0, 1) == 1;
  return arguments;
}

RequestedRun requested_run(const Scene& scene, const RunArguments& arguments) {
  if (!arguments.steps && !arguments.accuracy) throw std::invalid_argument("--steps is required");
  const auto& scheme = scheme_named(arguments.scheme);
  RunSettings setup = parse_setup(arguments);
  const bool chosen = requests_optimal_grading(arguments.settings);
  if (chosen) setup.grading = optimal_grading(scheme, scene.problem);
  const Resolution resolution = resolution_of(setup, scene.problem.end);
  Options options = setup.options();
  options.all_solutions = arguments.all;
  if (arguments.threads) options.threads = parse_count("--threads", *arguments.threads, thread_counts);
  const auto grid = grid_of(resolution);
  if (grid) require_affordable(*grid, options.history);
  require_events(scene, arguments);
  require_several(scene, arguments);
  auto times = times_of(arguments, resolution, scene.problem.end);
  require_field(scene, arguments, times, grid);
  if (const auto reason = unsupported_reason(scheme, scene.problem, resolution))
    throw std::invalid_argument(fmt::format("--scheme = {}: {} {}", scheme.id, scheme.id, *reason));
  return {scheme,
          setup,
          resolution,
          grid,
          std::move(times),
          std::move(options),
          arguments.field.has_value(),
          chosen ? grid_text(setup.grading) : ""};
}

}  // namespace fde::bench
