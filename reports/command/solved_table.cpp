#include "command/solved_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <variant>

#include "command/checkpoint_file.hpp"
#include "history/block_kernels.hpp"
#include "observers/kept_columns.hpp"
#include "observers/reaction_path.hpp"
#include "scenes/number_text.hpp"
#include "stepping/optimal_grading.hpp"
#include "stepping/rates.hpp"
#include "sweep/experiment.hpp"
#include "trust/warnings.hpp"

namespace fde {
namespace {

constexpr int most_direct_steps = 1 << 21;  // beyond, hours
constexpr int most_rows = 10'000'000;
constexpr int most_threads = 1024;

constexpr double rounding = 1e-12;

Setup parse_setup(const RunArguments& arguments) {
  StepsOrAccuracy resolution;
  if (arguments.accuracy) {
    resolution = parse_accuracy(*arguments.accuracy);
    if (arguments.means.grid != MeansArguments{}.grid)
      reject_text("--grid", arguments.means.grid, "without --accuracy, whose schemes choose their times");
  } else {
    resolution = parse_count("--steps", *arguments.steps, 1, most_steps);
  }
  Setup setup = parse_means(arguments.means);
  setup.resolution = resolution;
  return setup;
}

// Throws std::invalid_argument where the run would take hours or print too much.
void require_affordable(const Grid& grid, HistoryKind history) {
  if (resolve(history, step_plan(grid)) == HistoryKind::direct && grid.steps > most_direct_steps) {
    throw std::invalid_argument(
        fmt::format("--history = direct: takes up to {} steps, its work grows with their square, not {}",
                    most_direct_steps, grid.steps));
  }
}

// The time of the grid that is t to rounding. Throws std::invalid_argument naming the neighbours of a time
// off the grid.
double time_at(const Grid& grid, double t) {
  const int nearest = grid.number(t);
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

// Every K-th time of the grid and the last, or so many of them from 0 to the end, evenly spread over the
// steps.
std::vector<double> spread_times(const RunArguments& arguments, const Grid& grid) {
  int count = 0;
  double stride = 0.0;
  if (arguments.every) {
    const int fewest = grid.steps / most_rows + 1;
    const int each = parse_count("--every", *arguments.every, fewest, most_steps);
    count = 1 + (grid.steps - 1) / each + 1;
    stride = each;
  } else {
    count = parse_count("--points", *arguments.points, 2, most_rows);
    stride = static_cast<double>(grid.steps) / (count - 1);
  }
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
    times.push_back(grid.time(std::min(grid.steps, static_cast<int>(std::lround(i * stride)))));
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// The times to print; none: all.
std::vector<double> times_of(const RunArguments& arguments, const Resolution& resolution, double end) {
  if (arguments.at) return parse_times(*arguments.at, resolution, end);
  const auto* grid = std::get_if<Grid>(&resolution);
  if (arguments.every || arguments.points) {
    if (grid == nullptr) throw std::invalid_argument("--every and --points: are only taken with --steps");
    return spread_times(arguments, *grid);
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

// A state may be finite and its energy not: throws NumericalFailure then.
void require_finite(const Vec& values, const SolvedTable& table, const Scheme& scheme,
                    const std::optional<Grid>& grid, double t) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw NumericalFailure(fmt::format("{}: {} not finite {}", scheme.id,
                                       table.names[static_cast<std::size_t>(i)], at_time(grid, t)));
  }
}

// Of the columns at times of a run, which are those of the path where it has states that tell reactions.
SolvedTable table_of(const Scene& scene, const Scheme& scheme, const std::optional<Grid>& grid,
                     const Trajectory& path, const std::vector<double>& times, const Rows& columns,
                     const std::vector<double>& asked) {
  const ReactionPath reactions(scene, grid, path);
  SolvedTable table{.names = printed_names(scene), .times = asked.empty() ? times : asked};
  const auto of_reactions = reactions.names();
  table.names.insert(table.names.end(), of_reactions.begin(), of_reactions.end());
  table.values.resize(std::ssize(table.names), std::ssize(table.times));
  Eigen::Index next = 0;
  for (Eigen::Index c = 0; c < columns.cols() && next < table.values.cols(); ++c) {
    const double t = times[static_cast<std::size_t>(c)];
    if (t != table.times[static_cast<std::size_t>(next)]) continue;
    const Vec values = printed_values(scene, t, columns.col(c));
    require_finite(values, table, scheme, grid, t);
    table.values.col(next++) << values, reactions.at(c, columns.col(c));
  }
  if (next < table.values.cols()) {
    throw std::logic_error(
        fmt::format("{} left out t = {}", scheme.id, table.times[static_cast<std::size_t>(next)]));
  }
  return table;
}

// What was not counted or is not known is left out, and the grid where it was named.
std::string cost_text(const Scene& scene, const Scheme& scheme, const Resolution& resolution,
                      const Cost& cost, HistoryKind history, double seconds, const std::string& chosen_grid,
                      const CheckpointFile* checkpoints) {
  const auto* grid = std::get_if<Grid>(&resolution);
  nlohmann::ordered_json shown{{"seconds", seconds}};
  const auto add = [&shown](const char* key, const auto& count) {
    if (count) shown[key] = *count;
  };
  add("rhs", cost.rhs_calls);
  add("newton", cost.newton_iterations);
  if (!chosen_grid.empty()) shown["grid"] = chosen_grid;
  if (grid != nullptr && cost.history_bytes) shown["history"] = name(resolve(history, step_plan(*grid)));
  add("history_bytes", cost.history_bytes);
  add("states", cost.states);
  if (!cost.linear_solver.empty()) shown["linear_solver"] = cost.linear_solver;
  add("start_weights", cost.start_weights);
  add("rejected_steps", cost.rejected_steps);
  if (checkpoints != nullptr) {
    const auto& spent = checkpoints->spent();
    shown["continued"] = checkpoints->resumed();
    shown["checkpoints"] = spent.count;
    shown["checkpoint_bytes"] = spent.bytes;
    shown["checkpoint_seconds"] = spent.seconds;
  }
  if (grid != nullptr)
    add("expected_rate", theoretical_rate(scheme, scene.problem, scene.smoothness, *grid, Norm::end));
  return shown.dump();
}

// The column that shows a component as it is, "" where none does: seen where all components differ.
std::vector<std::string> columns_of_components(const Scene& scene) {
  const Vec y = Vec::LinSpaced(scene.problem.size(), 0.1, 0.7);
  const Vec columns = columns_at(scene.outputs, 0.0, y);
  std::vector<std::string> names(static_cast<std::size_t>(y.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto shown = std::ranges::find(columns, y[static_cast<Eigen::Index>(i)]);
    if (shown != columns.end())
      names[i] = scene.outputs.names[static_cast<std::size_t>(shown - columns.begin())];
  }
  return names;
}

// One line of all that speaks against the numbers of a run; empty: nothing.
std::string warning_line(const SolvedRun& run, bool check) {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings(run, check)) texts.push_back(warning.text);
  return texts.empty() ? "" : fmt::format("warning: {}", fmt::join(texts, "; "));
}

// The times to print, as they were asked for.
std::string times_text(const RunArguments& arguments) {
  if (arguments.at) return "--at " + *arguments.at;
  if (arguments.every) return "--every " + *arguments.every;
  return arguments.points ? "--points " + *arguments.points : "all";
}

RunFacts facts_of(const Scene& scene, const Scheme& scheme, const Setup& setup,
                  const RunArguments& arguments) {
  const Session session = this_session();
  return {{"program",
           fmt::format("{} {} {} {}", session.version, session.commit, session.compiler, session.flags)},
          {"instructions", std::string(vector_targets().front())},
          {"scene", scene.name},
          {"end", fmt::format("{}", scene.problem.end)},
          {"scheme", std::string(scheme.id)},
          {"steps", resolution_text(setup)},
          {"grid", grid_text(setup.grading)},
          {"history", std::string(name(setup.history))},
          {"tolerance", fmt::format("{}", setup.tolerance)},
          {"times", times_text(arguments)}};
}

std::optional<CheckpointFile> checkpoint_file(const Scene& scene, const Scheme& scheme, const Setup& setup,
                                              const RunArguments& arguments, KeptColumns& kept,
                                              const std::function<void(const std::string&)>& say) {
  if (!arguments.checkpoint) {
    if (arguments.checkpoint_every)
      reject_text("--checkpoint-every", *arguments.checkpoint_every, "with --checkpoint");
    return std::nullopt;
  }
  constexpr double usual = 300.0;
  const double between = arguments.checkpoint_every
                             ? parse_number("--checkpoint-every", *arguments.checkpoint_every, not_negative)
                             : usual;
  if (const auto reason = refusal_of_checkpoints(scheme, scene.problem))
    reject_text("--checkpoint", *arguments.checkpoint, fmt::format("left out: {} {}", scheme.id, *reason));
  return std::optional<CheckpointFile>(
      std::in_place, *arguments.checkpoint, std::chrono::duration<double>(between),
      facts_of(scene, scheme, setup, arguments), [&kept](Archive& archive) { archive(kept); }, say);
}

}  // namespace

SolvedTable solved_table(const Scene& scene, const RunArguments& arguments,
                         const std::function<void(const std::string&)>& say) {
  if (!arguments.steps && !arguments.accuracy) throw std::invalid_argument("--steps is required");
  const auto& scheme = scheme_named(arguments.scheme);
  Setup setup = parse_setup(arguments);
  const bool chosen = asks_optimal_grading(arguments.means);
  if (chosen) setup.grading = optimal_grading(scheme, scene.problem);
  const Resolution resolution = resolution_of(setup, scene.problem.end);
  Options options = setup.options();
  if (arguments.threads) options.threads = parse_count("--threads", *arguments.threads, 1, most_threads);
  const auto grid = grid_of(resolution);
  if (grid) require_affordable(*grid, options.history);
  const auto asked = times_of(arguments, resolution, scene.problem.end);
  // Without reactions columns are all there is to keep, and the states that warnings look at.
  const bool by_columns = grid && !scene.reactions;
  KeptColumns kept(scene.outputs, asked);
  if (by_columns) options.observer = [&kept](double t, In y) { kept.observe(t, y); };
  options.at = by_columns ? std::vector{scene.problem.end} : with_times_beside(scene.reactions, grid, asked);
  if (grid) options.at = with_times_looked_at(scene.problem, *grid, options.at);
  if (const auto reason = refusal(scheme, scene.problem, resolution)) {
    throw std::invalid_argument(fmt::format("--scheme = {}: {} {}", scheme.id, scheme.id, *reason));
  }

  auto checkpoints = checkpoint_file(scene, scheme, setup, arguments, kept, say);
  if (checkpoints) options.checkpoints = &*checkpoints;
  const auto start = std::chrono::steady_clock::now();
  const Trajectory path = scheme.solve(scene.problem, resolution, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (checkpoints && path.ending != Ending::finished && path.ending != Ending::out_of_budget)
    checkpoints->remove();
  if (path.ending != Ending::finished)
    throw RunFailure(fmt::format("{}: {}", scheme.id, describe(scene.problem, path)), scheme.id, path);
  SolvedTable table =
      by_columns ? table_of(scene, scheme, grid, path, kept.times(), kept.columns(), asked)
                 : table_of(scene, scheme, grid, path, path.times, columns_of(scene.outputs, path), asked);
  if (checkpoints) table.checkpoint = *arguments.checkpoint;
  if (grid) {
    table.warning = warning_line({scheme, scene.problem, *grid, options, path, columns_of_components(scene)},
                                 arguments.check);
  }
  table.cost = cost_text(scene, scheme, resolution, path.cost, options.history, elapsed.count(),
                         chosen ? grid_text(setup.grading) : "", checkpoints ? &*checkpoints : nullptr);
  return table;
}

}  // namespace fde
