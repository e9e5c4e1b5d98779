#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "command/arguments.hpp"
#include "command/command.hpp"
#include "scenes/number_text.hpp"
#include "scenes/registry.hpp"
#include "sweep/experiment.hpp"

namespace fde {
namespace {

constexpr int most_direct_steps = 1 << 21;  // beyond, hours
constexpr int most_rows = 10'000'000;

struct SolveArguments {
  std::string scene, scheme, steps, grid = "uniform", history = "auto";
  std::optional<std::string> until, at, tolerance;
  std::string budget = "3600";
  std::vector<std::string> settings;
  bool cost = false;
};

// The step whose time is t to rounding. Throws std::invalid_argument naming the neighbours of a time off the
// grid.
int step_at(const Grid& grid, double t) {
  constexpr double rounding = 1e-12;
  if (t > grid.end * (1 + rounding))
    reject("--at", t, fmt::format("in [0, {}], the times of the run", grid.end));
  const double guess = grid.steps * std::pow(t / grid.end, 1.0 / grid.grading);
  const int nearest_step = std::clamp(static_cast<int>(std::lround(guess)), 0, grid.steps);
  if (std::abs(grid.time(nearest_step) - t) <= rounding * t) return nearest_step;
  const int below =
      std::clamp(grid.time(nearest_step) < t ? nearest_step : nearest_step - 1, 0, grid.steps - 1);
  reject("--at", t,
         fmt::format("a time of the grid: its neighbours are {:.17g} and {:.17g}", grid.time(below),
                     grid.time(below + 1)));
}

std::vector<int> steps_at(const Grid& grid, const std::string& times) {
  std::vector<int> steps;
  for (const double t : parse_numbers("--at", times, not_negative)) steps.push_back(step_at(grid, t));
  std::ranges::sort(steps);
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

HistoryKind parse_history(const std::string& text) {
  if (text == "auto") return HistoryKind::automatic;
  if (text == "direct") return HistoryKind::direct;
  if (text == "exponentials") return HistoryKind::exponentials;
  throw std::invalid_argument(fmt::format("--history = {}: must be auto, direct or exponentials", text));
}

// The columns to print, one row a column, one column a step. A state may be finite and its energy not: throws
// NumericalFailure then.
Rows printed(const Scene& scene, const Scheme& scheme, const Trajectory& path) {
  const auto names = printed_names(scene);
  Rows values(std::ssize(names), path.y.cols());
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const int n = path.steps[static_cast<std::size_t>(c)];
    const double t = path.grid.time(n);
    values.col(c) = printed_values(scene, t, columns_at(scene.outputs, t, path.y.col(c)));
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (std::isfinite(values(i, c))) continue;
      throw NumericalFailure(fmt::format("{}: {} not finite at step {}, t = {:.6g}", scheme.id,
                                         names[static_cast<std::size_t>(i)], n, t));
    }
  }
  return values;
}

void print_rows(const Scene& scene, const Rows& values, const Trajectory& path, std::ostream& out) {
  fmt::print(out, "t,{}\n", fmt::join(printed_names(scene), ","));
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    fmt::print(out, "{:.17g}", path.grid.time(path.steps[static_cast<std::size_t>(c)]));
    for (const double value : values.col(c)) fmt::print(out, ",{:.17g}", value);
    fmt::print(out, "\n");
  }
}

void print_cost(const Scene& scene, const Scheme& scheme, const Trajectory& path, HistoryKind history,
                double seconds, std::ostream& err) {
  const nlohmann::ordered_json cost{
      {"seconds", seconds},
      {"rhs", path.cost.rhs_calls},
      {"newton", path.cost.newton_iterations},
      {"history", name(resolve(history, step_plan(path.grid)))},
      {"history_bytes", path.cost.history_bytes},
      {"states", path.cost.states},
      {"expected_rate", scheme.expected_rate(scene.problem, scene.smoothness, path.grid.grading, Norm::end)}};
  fmt::print(err, "{}\n", cost.dump());
}

void solve(const SolveArguments& arguments, const Streams& streams) {
  const auto& maker = scene_named(arguments.scene);
  const auto& scheme = scheme_named(arguments.scheme);
  SceneVariant variant{.maker = &maker, .values = parse_settings(maker, arguments.settings)};
  if (arguments.until) variant.until = parse_number("--until", *arguments.until, any_end);
  const Scene scene = make_scene(variant);
  const Grid grid =
      parse_grid(arguments.grid, scene.problem.end, parse_count("--steps", arguments.steps, 1, most_steps));
  Options options{.history = parse_history(arguments.history)};
  if (resolve(options.history, step_plan(grid)) == HistoryKind::direct && grid.steps > most_direct_steps) {
    throw std::invalid_argument(
        fmt::format("--history = direct: takes up to {} steps, its work grows with their square, not {}",
                    most_direct_steps, grid.steps));
  }
  if (!arguments.at && grid.steps > most_rows) {
    throw std::invalid_argument(
        fmt::format("--at is needed beyond {} steps, not all {} are printed", most_rows, grid.steps));
  }
  if (arguments.at) options.keep = steps_at(grid, *arguments.at);
  if (arguments.tolerance) {
    options.tolerance = parse_number("--tolerance", *arguments.tolerance, {.low = 0.0, .high = 1.0});
  }
  options.budget = parse_number("--budget", arguments.budget, positive);
  if (const auto reason = refusal(scheme, scene.problem, grid)) {
    throw std::invalid_argument(fmt::format("--scheme = {}: {} {}", scheme.id, scheme.id, *reason));
  }

  const auto start = std::chrono::steady_clock::now();
  const Trajectory path = scheme.solve(scene.problem, grid, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (path.ending != Ending::finished)
    throw NumericalFailure(fmt::format("{}: {}", scheme.id, describe(scene.problem, path)));
  print_rows(scene, printed(scene, scheme, path), path, streams.out);
  if (arguments.cost) print_cost(scene, scheme, path, options.history, elapsed.count(), streams.err);
}

}  // namespace

void add_solve_command(CLI::App& app, const Streams& streams) {
  auto arguments = std::make_shared<SolveArguments>();
  auto* command = app.add_subcommand("solve", "Solve a scene with a scheme; CSV on standard output");
  command->add_option("scene", arguments->scene, "id of the scene")->required();
  command->add_option("--scheme", arguments->scheme, "id of the scheme")->required();
  command->add_option("--steps", arguments->steps, "number of steps N")->required();
  command->add_option("--until", arguments->until, "end of the time interval");
  command->add_option("--set", arguments->settings, "a parameter of the scene, NAME=VALUE")->take_all();
  command->add_option("--at", arguments->at, "grid times to print, T1,T2,...; default all");
  command->add_option("--grid", arguments->grid, "uniform or graded:R");
  command->add_option("--history", arguments->history, "auto, direct or exponentials");
  command->add_option("--tolerance", arguments->tolerance,
                      "relative, of Newton's method and of the weights of the past; default rounding");
  command->add_option("--budget", arguments->budget, "seconds after which the run ends; default 3600");
  command->add_flag("--cost", arguments->cost, "one JSON line on standard error: time, calls, memory, rate");
  command->callback([=] { solve(*arguments, streams); });
}

}  // namespace fde
