// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/requested_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde::bench {
namespace {

constexpr int most_direct_steps = 1 << 21;  // more steps take hours

constexpr double rounding = 1e-12;

// Of the values of a request that a struct can hold and a run cannot have.
void require_ranges(const SolveRequest& request) {
  require_allowed(request.settings.resolution);
  const bool uniform = !request.optimal_grading && request.settings.grading == 1.0;
  if (std::holds_alternative<Tolerance>(request.settings.resolution) && !uniform) {
    refuse_value("grid",
                 request.optimal_grading ? std::string(optimal_grid) : grid_text(request.settings.grading),
                 {"without ", RequestField{"accuracy"}, ", whose schemes choose their times"});
  }
  require_allowed(request.settings);
  require_in("threads", request.threads, thread_counts);
  if (!(request.settings.budget > 0.0))
    refuse_value("budget", fmt::format("{}", request.settings.budget), {positive.text()});
}

// Direct sums of more steps would take hours.
void require_affordable(const Grid& grid, HistoryKind history) {
  if (history != HistoryKind::direct || grid.steps <= most_direct_steps) return;
  throw Refusal({RequestField{"history"},
                 fmt::format(" = direct: takes up to {} steps, its work grows with their square, not {}",
                             most_direct_steps, grid.steps)});
}

// The grid time that equals t up to rounding. Throws Refusal naming the neighbours if t is not a grid time.
double time_at(const Scene& scene, const Grid& grid, double t) {
  const int nearest = grid.nearest_index(t);
  if (std::abs(grid.time(nearest) - t) <= rounding * t) return grid.time(nearest);
  const int below = std::clamp(grid.time(nearest) < t ? nearest : nearest - 1, 0, grid.steps - 1);
  refuse_value("at", fmt::format("{}", from_zero(scene, t)),
               {fmt::format("a time of the grid: its neighbours are {:.17g} and {:.17g}",
                            from_zero(scene, grid.time(below)), from_zero(scene, grid.time(below + 1)))});
}

// The times of one kind of OutputTimes for a run over a grid, or without one (nullptr) up to the end.
struct TimesOfRun {
  const Grid* grid;
  double end;
  const Scene* scene;  // whose start users add to all of them

  std::vector<double> operator()(const AllTimes& /*all*/) const {
    if (grid == nullptr || grid->steps <= most_rows) return {};
    throw Refusal(
        {RequestField{"at"}, ", ", RequestField{"every"}, " or ", RequestField{"points"},
         fmt::format(" is needed beyond {} steps, not all {} are printed", most_rows, grid->steps)});
  }

  std::vector<double> operator()(const GivenTimes& at) const {
    if (at.times.empty()) refuse_value("at", "[]", {"one time at least"});
    std::vector<double> times;
    for (const double asked : at.times) {
      require_in("at", asked, not_negative);
      const double t = from_start(*scene, asked);
      if (t < 0.0 || t > end * (1 + rounding)) {
        refuse_value(
            "at", fmt::format("{}", asked),
            {fmt::format("in [{}, {}], the times of the run", scene->start, from_zero(*scene, end))});
      }
      times.push_back(grid != nullptr ? time_at(*scene, *grid, t) : t);
    }
    return increasing(std::move(times));
  }

  std::vector<double> operator()(const EveryTime& every) const {
    if (grid == nullptr) {
      refuse_value("every", fmt::format("{}", every.stride),
                   {"with ", RequestField{"steps"}, "; with ", RequestField{"accuracy"}, " ",
                    RequestField{"points"}, " K prints K equal times"});
    }
    require_in("every", every.stride, CountRange{grid->steps / most_rows + 1, most_steps});
    return of_grid(1 + (grid->steps - 1) / every.stride + 1, every.stride);
  }

  std::vector<double> operator()(const SpreadTimes& points) const {
    require_in("points", points.count, point_counts);
    if (grid != nullptr) return of_grid(points.count, static_cast<double>(grid->steps) / (points.count - 1));
    std::vector<double> times;
    for (int i = 0; i < points.count; ++i)
      times.push_back(i == points.count - 1 ? end : end * i / (points.count - 1));
    return times;
  }

 private:
  // So many times of the grid, a number of steps apart; the last one is the end.
  [[nodiscard]] std::vector<double> of_grid(int count, double stride) const {
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
      times.push_back(grid->time(std::min(grid->steps, static_cast<int>(std::lround(i * stride)))));
    return increasing(std::move(times));
  }
};

// Throws Refusal if events are requested and the run or the scene has none.
void require_events(const Scene& scene, const SolveRequest& request) {
  if (!request.events) return;
  if (!std::holds_alternative<Tolerance>(request.settings.resolution))
    throw Refusal({RequestField{"events"}, ": is only taken with ", RequestField{"accuracy"}});
  if (!std::holds_alternative<AllTimes>(request.times)) {
    throw Refusal({RequestField{"events"}, ": is not taken with ", RequestField{"at"}, " and ",
                   RequestField{"points"}});
  }
  if (scene.events.empty())
    throw Refusal({RequestField{"events"}, ": the scene has none; a file declares them under [event.NAME]"});
}

// Throws Refusal if a field is requested of more than 2e8 values, or with what excludes it.
void require_field(const Scene& scene, const SolveRequest& request, const std::vector<double>& times,
                   const std::optional<Grid>& grid) {
  if (!request.field) return;
  constexpr double most_values = 2e8;
  const auto refuse = [](const char* other) {
    throw Refusal({RequestField{"field"}, ": is not taken with ", RequestField{other}});
  };
  if (request.checkpoint) refuse("checkpoint");
  if (request.events) refuse("events");
  if (request.all_solutions) refuse("all");
  const double rows = times.empty() && grid ? grid->steps + 1.0 : static_cast<double>(times.size());
  const double values = rows * static_cast<double>(scene.problem.size());
  if (values <= most_values) return;
  throw Refusal(
      {RequestField{"field"}, fmt::format(": has at most {:g} values, not {:g}: ", most_values, values),
       RequestField{"at"}, ", ", RequestField{"every"}, " and ", RequestField{"points"}, " choose times"});
}

// Throws Refusal if all solutions are requested of a problem that is solved by initial value problems, or
// with a comparison of one.
void require_several(const Scene& scene, const SolveRequest& request) {
  if (!request.all_solutions) return;
  if (!is_two_sided(scene.problem))
    throw Refusal({RequestField{"all"}, ": is only taken of problems at both ends"});
  if (!has_right_rows(scene.problem)) {
    throw Refusal(
        {RequestField{"all"},
         ": is only taken of problems with right derivatives, which are solved at all times at once"});
  }
  if (request.check) throw Refusal({RequestField{"all"}, ": is not taken with ", RequestField{"check"}});
}

}  // namespace

RequestedRun requested_run(const Scene& scene, const SolveRequest& request) {
  const Scheme& scheme = scheme_named(request.scheme);
  require_ranges(request);
  RequestedRun run{.scheme = scheme,
                   .settings = request.settings,
                   .resolution = {},
                   .grid = {},
                   .times = {},
                   .options = {},
                   .keeps_columns = false};
  if (request.optimal_grading) run.settings.grading = optimal_grading(scheme, scene.problem);
  run.resolution = resolution_of(run.settings, scene.problem.end);
  run.options = run.settings.options();
  run.options.all_solutions = request.all_solutions;
  run.options.threads = request.threads;
  const auto* grid = std::get_if<Grid>(&run.resolution);
  if (grid != nullptr) {
    run.grid = *grid;
    require_affordable(*grid, run.options.history);
  }
  run.keeps_columns = run.grid && !scene.reactions && !request.field && !request.all_solutions;
  require_events(scene, request);
  require_several(scene, request);
  run.times = std::visit(TimesOfRun{grid, scene.problem.end, &scene}, request.times);
  require_field(scene, request, run.times, run.grid);
  if (const auto reason = unsupported_reason(scheme, scene.problem, run.resolution))
    throw Refusal({RequestField{"scheme"}, fmt::format(" = {}: {} {}", scheme.id, scheme.id, *reason)});
  return run;
}

}  // namespace fde::bench
