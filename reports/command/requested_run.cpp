// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/requested_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

constexpr int most_direct_steps = 1 << 21;  // more steps take hours

constexpr double rounding = 1e-12;

RunSettings parse_setup(const Given& given) {
  StepsOrTolerance resolution;
  if (const auto accuracy = given.find("--accuracy")) {
    resolution = parse_accuracy(*accuracy);
    if (given.text("--grid") != uniform_grid)
      given.refuse("--grid", "without --accuracy, whose schemes choose their times");
  } else {
    resolution = given.count("--steps");
  }
  RunSettings setup = parse_run_settings(given);
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

std::vector<double> parse_times(const Given& given, const Resolution& resolution, double end) {
  const auto* grid = std::get_if<Grid>(&resolution);
  std::vector<double> times;
  for (const double t : given.numbers("--at")) {
    if (t > end * (1 + rounding)) reject("--at", t, fmt::format("in [0, {}], the times of the run", end));
    times.push_back(grid != nullptr ? time_at(*grid, t) : t);
  }
  return increasing(std::move(times));
}

// The grid times of --every K (every K-th and the last) or --points K (K times from 0 to the end, equally
// spaced in the step number).
std::vector<double> spread_times(const Given& given, const Grid& grid) {
  int count = 0;
  double stride = 0.0;
  if (const auto every = given.find("--every")) {
    const int fewest = grid.steps / most_rows + 1;
    const int each = parse_count("--every", *every, fewest, most_steps);
    count = 1 + (grid.steps - 1) / each + 1;
    stride = each;
  } else {
    count = given.count("--points");
    stride = static_cast<double>(grid.steps) / (count - 1);
  }
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
    times.push_back(grid.time(std::min(grid.steps, static_cast<int>(std::lround(i * stride)))));
  return increasing(std::move(times));
}

// `count` equally spaced times from 0 to the end.
std::vector<double> spread_times(int count, double end) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(i == count - 1 ? end : end * i / (count - 1));
  return times;
}

// The output times; empty: all.
std::vector<double> times_of(const Given& given, const Resolution& resolution, double end) {
  const bool has_every = given.has("--every"), has_points = given.has("--points");
  if (std::ranges::count(std::array{given.has("--at"), has_every, has_points}, true) > 1)
    throw std::invalid_argument("--at, --every and --points: one of them at most");
  if (given.has("--at")) return parse_times(given, resolution, end);
  const auto* grid = std::get_if<Grid>(&resolution);
  if (has_every || has_points) {
    if (grid != nullptr) return spread_times(given, *grid);
    if (has_every) given.refuse("--every", "with --steps; with --accuracy --points K prints K equal times");
    return spread_times(given.count("--points"), end);
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
void require_events(const Scene& scene, const Given& given) {
  if (!given.has("--events")) return;
  if (!given.has("--accuracy")) throw std::invalid_argument("--events: is only taken with --accuracy");
  if (given.has("--at") || given.has("--points"))
    throw std::invalid_argument("--events: is not taken with --at and --points");
  if (scene.events.empty())
    throw std::invalid_argument("--events: the scene has none; a file declares them under [event.NAME]");
}

// Throws std::invalid_argument if --field is given with more than 2e8 values, or with an option that excludes
// it.
void require_field(const Scene& scene, const Given& given, const std::vector<double>& times,
                   const std::optional<Grid>& grid) {
  if (!given.has("--field")) return;
  constexpr double most_values = 2e8;
  if (given.has("--checkpoint")) given.refuse("--field", "without --checkpoint");
  if (given.has("--events")) given.refuse("--field", "without --events");
  const double rows = times.empty() && grid ? grid->steps + 1.0 : static_cast<double>(times.size());
  const double values = rows * static_cast<double>(scene.problem.size());
  if (values <= most_values) return;
  given.refuse("--field",
               fmt::format("of at most {:g} values, not {:g}: --at, --every and --points choose times",
                           most_values, values));
}

// Throws std::invalid_argument if --all is given for an initial value problem, or with an option that
// excludes it.
void require_several(const Scene& scene, const Given& given) {
  if (!given.has("--all")) return;
  if (!is_two_sided(scene.problem))
    throw std::invalid_argument("--all: is only taken of problems at both ends");
  if (given.has("--field")) given.refuse("--field", "without --all");
  if (given.has("--check")) throw std::invalid_argument("--all: is not taken with --check");
}

}  // namespace

Given given_to_solve(const std::string& scheme, const std::map<std::string, std::string>& texts) {
  const Words known{"accuracy", "at",     "budget", "check",   "every",    "grid",
                    "history",  "points", "steps",  "threads", "tolerance"};
  Given given(solve_command().text, {{"--scheme", {scheme}}});
  for (const auto& [name, text] : texts) {
    if (std::ranges::find(known, name) == known.end())
      reject_text("option", name, fmt::format("of {}", fmt::join(known, ", ")));
    if (name != "check" || parse_count("--check", text, 0, 1) == 1) given.set("--" + name, {text});
  }
  return given;
}

RequestedRun requested_run(const Scene& scene, const Given& given) {
  if (!given.has("--steps") && !given.has("--accuracy")) throw std::invalid_argument("--steps is required");
  const auto& scheme = scheme_named(given.text("--scheme"));
  RunSettings setup = parse_setup(given);
  const bool chosen = given.text("--grid") == optimal_grid;
  if (chosen) setup.grading = optimal_grading(scheme, scene.problem);
  const Resolution resolution = resolution_of(setup, scene.problem.end);
  Options options = setup.options();
  options.all_solutions = given.has("--all");
  options.threads = given.count("--threads");
  const auto grid = grid_of(resolution);
  if (grid) require_affordable(*grid, options.history);
  require_events(scene, given);
  require_several(scene, given);
  auto times = times_of(given, resolution, scene.problem.end);
  require_field(scene, given, times, grid);
  if (const auto reason = unsupported_reason(scheme, scene.problem, resolution))
    throw std::invalid_argument(fmt::format("--scheme = {}: {} {}", scheme.id, scheme.id, *reason));
  return {scheme,
          setup,
          resolution,
          grid,
          std::move(times),
          std::move(options),
          given.has("--field"),
          chosen ? grid_text(setup.grading) : ""};
}

}  // namespace fde::bench
