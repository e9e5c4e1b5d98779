// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/other_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fde {

namespace {

// Steps times components: of finer runs that take a fraction of a millisecond, and of coarser ones.
constexpr Eigen::Index finer_work = 8192, coarser_work = 2048;
constexpr Eigen::Index fewest_times = 4, most_times = 16;

// How many times as many steps a finer run takes in so much work.
Eigen::Index affordable_times(const SolvedRun& run, Eigen::Index work) {
  return is_two_sided(run.problem) ? 0 : work / (run.problem.size() * run.grid.steps);
}

Grid with_steps(const Grid& grid, int steps) { return {grid.end, steps, grid.grading}; }

// The numbers of steps of the finer of two coarser runs, one after the other until they decide.
std::vector<int> coarser_steps(const Problem& problem, const Grid& grid) {
  const int half = grid.steps / 2;
  // Problems at both ends take longer, and their solutions do not run away from a coarse one.
  const Eigen::Index cheap = is_two_sided(problem)
                                 ? std::max(grid.steps / 16, 16)
                                 : std::max<Eigen::Index>(grid.steps / 64, coarser_work / problem.size());
  std::vector<int> steps;
  for (const int count : {static_cast<int>(std::min<Eigen::Index>(half, cheap)), grid.steps / 8, half}) {
    if (count >= 2 && (steps.empty() || count > steps.back())) steps.push_back(count);
  }
  return steps;
}

// The largest difference of two paths at these times.
struct Difference {
  double part = 0.0;
  Eigen::Index quantity = 0;
  double t = 0.0, value = 0.0, other = 0.0;
};

Difference difference(const SolvedRun& run, const Trajectory& path, const Trajectory& other,
                      const std::vector<double>& times, const Vec& sizes) {
  Difference worst;
  for (const double t : times) {
    const Vec y = run.quantities(path, t), z = run.quantities(other, t);
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const double apart = std::abs(y[i] - z[i]);
      if (apart > worst.part * sizes[i])
        worst = {.part = apart / sizes[i], .quantity = i, .t = t, .value = y[i], .other = z[i]};
    }
  }
  return worst;
}

std::string numbers(const Difference& worst, const SolvedRun& run, int steps) {
  return fmt::format("{} at t = {:.6g} is {:.3g} with {} step{} and {:.3g} with {}", run.name(worst.quantity),
                     worst.t, worst.value, run.grid.steps, run.grid.steps == 1 ? "" : "s", worst.other,
                     steps);
}

ComparedSteps of_difference(const Difference& worst, bool significant, const SolvedRun& run, int steps) {
  if (!significant) return {.agreement = Agreement::agrees};
  return {.agreement = Agreement::differs, .numbers = numbers(worst, run, steps)};
}

ComparedSteps compare_with_finer(const SolvedRun& run, Eigen::Index times_as_many) {
  const Grid grid = with_steps(run.grid, static_cast<int>(times_as_many) * run.grid.steps);
  const auto times = late_times(run.grid);
  const auto finer = solve_again(run, run.scheme, grid, times);
  if (finer.status == SolveStatus::finished) {
    const auto worst = difference(run, run.path, finer, times, late_sizes(run));
    return of_difference(worst, worst.part > significant_part, run, grid.steps);
  }
  // Newton's method and the budget may end a run of more steps that says nothing against this one.
  if (finer.status != SolveStatus::non_finite && finer.status != SolveStatus::left_domain) return {};
  return {.agreement = Agreement::differs,
          .numbers =
              fmt::format("with {} steps the run breaks off after t = {:.6g}", grid.steps, finer.last_time)};
}

// The error of a run from those of two coarser ones; see compare_with_other_steps.
double error_by_rate(double to_finer, double between, double ratio) {
  constexpr double lowest = 0.5, highest = 2.0;
  double rate = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double quotient = between / to_finer * (1.0 - std::pow(ratio, -rate));
    rate = std::clamp(std::log2(1.0 + quotient), lowest, highest);
  }
  return to_finer / (std::pow(ratio, rate) - 1.0);
}

// nullopt: the coarser run is nothing that could be compared.
struct Estimate {
  double error;
  std::string numbers;
};

std::optional<Estimate> estimate_from_coarser(const SolvedRun& run, int steps) {
  // Farther away than this it is something else, not the same solution with a larger error.
  constexpr double comparable = 10.0;
  const Grid finer = with_steps(run.grid, steps), coarser = with_steps(run.grid, steps / 2);
  const auto times = late_times(coarser);
  const auto one = solve_again(run, run.scheme, finer, times);
  if (one.status != SolveStatus::finished) return std::nullopt;
  const Vec sizes = late_sizes(run);
  const auto worst = difference(run, run.path, one, times, sizes);
  if (worst.part == 0.0) return Estimate{0.0, {}};
  if (!(worst.part < comparable)) return std::nullopt;
  const auto other = solve_again(run, run.scheme, coarser, times);
  const double between = other.status == SolveStatus::finished
                             ? difference(run, one, other, times, sizes).part
                             : 0.0;  // the lowest rate
  const double ratio = static_cast<double>(run.grid.steps) / steps;
  return Estimate{error_by_rate(worst.part, between, ratio), numbers(worst, run, steps)};
}

constexpr double rounding = 1e-12;

// The time of the step that has gone this part of all steps, after the first.
double time_of_part(const Grid& grid, double part) {
  return grid.time(std::max(1, static_cast<int>(std::lround(part * grid.steps))));
}

}  // namespace

// A first step may be too short, and only then: what it would have shown is unknown.
Trajectory solve_again(const SolvedRun& run, const Scheme& scheme, const Grid& grid,
                       const std::vector<double>& times) {
  if (unsupported_reason(scheme, run.problem, grid)) return {.status = SolveStatus::refused};
  Options options = run.options;
  options.output_times = grid_times_at(grid, times);
  options.observer = {};
  options.checkpoints = nullptr;
  return scheme.solve(run.problem, grid, options);
}

std::string SolvedRun::name(Eigen::Index quantity) const {
  const auto index = static_cast<std::size_t>(quantity);
  if (index < names.size() && !names[index].empty()) return names[index];
  return fmt::format("component {}", quantity);
}

Vec SolvedRun::quantities(const Trajectory& of, double t) const {
  Vec y = stored_at(of, t);
  if (!functions) return y;
  const Vec values = functions(t, y);
  Vec all(y.size() + values.size());
  all << y, values;
  return all;
}

Vec late_sizes(const SolvedRun& run) {
  constexpr double of_component = 1e-9, of_all = 1e-12;
  const auto largest = [&run](const std::vector<double>& times) {
    Vec size = run.quantities(run.path, times.front()).cwiseAbs();
    for (const double t : times) size = size.cwiseMax(run.quantities(run.path, t).cwiseAbs());
    return size;
  };
  const Vec late = largest(late_times(run.grid)), ever = largest(spread_times(run.grid));
  const double all = of_all * ever.cwiseMax(late).maxCoeff();
  return late.cwiseMax(of_component * ever).cwiseMax(Vec::Constant(late.size(), all));
}

ComparedSteps compare_with_other_steps(const SolvedRun& run) {
  const auto at_once = affordable_times(run, finer_work);
  if (at_once >= fewest_times) {
    auto finer = compare_with_finer(run, std::min(at_once, most_times));
    if (finer.agreement != Agreement::unknown) return finer;
  }
  // An estimate is uncertain by half; where a finer run can decide, any sign suffices.
  const bool settled = at_once < fewest_times && affordable_times(run, longest_settled) > 0;
  const double enough = (settled ? 0.5 : 1.5) * significant_part;
  std::optional<Estimate> last;
  for (const int steps : coarser_steps(run.problem, run.grid)) {
    last = estimate_from_coarser(run, steps);
    if (last && last->error <= enough) return {.agreement = Agreement::agrees};
  }
  if (settled) {
    auto finer = compare_with_finer(run, fewest_times);
    if (finer.agreement != Agreement::unknown) return finer;
  }
  if (!last || last->error <= 1.5 * significant_part) return {};
  return {.agreement = Agreement::differs, .numbers = last->numbers};
}

ComparedSteps compare_with_half_the_steps(const SolvedRun& run) {
  const int steps = run.grid.steps / 2;
  if (steps == 0) return {};
  const auto times = late_times(with_steps(run.grid, steps));
  const auto half = solve_again(run, run.scheme, with_steps(run.grid, steps), times);
  if (half.status == SolveStatus::refused || half.status == SolveStatus::out_of_budget) return {};
  if (half.status != SolveStatus::finished) {
    return {
        .agreement = Agreement::differs,
        .numbers = fmt::format("with {} steps the run breaks off after t = {:.6g}", steps, half.last_time)};
  }
  const auto worst = difference(run, run.path, half, times, late_sizes(run));
  return of_difference(worst, worst.part > significant_part, run, steps);
}

std::vector<double> times_compared(const Problem& problem, const Grid& grid) {
  auto times = late_times(grid);
  const auto add = [&times](const std::vector<double>& more) {
    std::ranges::copy(more, std::back_inserter(times));
  };
  add(spread_times(grid));
  for (const double t : spread_times(grid)) {
    for (const double lag : problem.delays.lags)
      if (t > lag) times.push_back(t - lag);
  }
  for (const int steps : coarser_steps(problem, grid)) add(late_times(with_steps(grid, steps / 2)));
  if (grid.steps > 1) add(late_times(with_steps(grid, grid.steps / 2)));
  return grid_times_at(grid, times);
}

std::vector<double> grid_times_at(const Grid& grid, const std::vector<double>& times) {
  std::vector<double> found;
  for (const double t : times) {
    const int nearest = grid.nearest_index(t);
    found.push_back(grid.time(nearest));
    if (std::abs(grid.time(nearest) - t) <= rounding * t) continue;
    const int beside = grid.time(nearest) < t ? nearest + 1 : nearest - 1;
    found.push_back(grid.time(std::clamp(beside, 0, grid.steps)));
  }
  return increasing(found);
}

Vec stored_at(const Trajectory& path, double t) {
  const auto above = std::ranges::lower_bound(path.times, t * (1.0 - rounding));
  const auto column =
      std::min(static_cast<Eigen::Index>(above - path.times.begin()), path.y.cols() - Eigen::Index{1});
  const double end = path.time(column);
  if (column == 0 || end <= t * (1.0 + rounding)) return path.y.col(column);
  const double begin = path.time(column - 1), share = (t - begin) / (end - begin);
  return (1.0 - share) * path.y.col(column - 1) + share * path.y.col(column);
}

std::vector<double> late_times(const Grid& grid) {
  std::vector<double> times;
  for (const double part : {0.75, 0.8125, 0.875, 0.9375, 1.0}) times.push_back(time_of_part(grid, part));
  return increasing(times);
}

std::vector<double> spread_times(const Grid& grid) {
  return increasing(std::vector{0.0, time_of_part(grid, 0.25), time_of_part(grid, 0.5), grid.end});
}

std::vector<double> last_times(const Grid& grid) {
  std::vector<double> times;
  for (int n = std::max(0, grid.steps - 3); n <= grid.steps; ++n) times.push_back(grid.time(n));
  return times;
}

}  // namespace fde
