#include "search/attempt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "measures/accuracy.hpp"
#include "observers/watched_steps.hpp"

namespace fde {
StepsOrAccuracy resolution_of(const Attempt& attempt) {
  if (attempt.asked) return Accuracy{*attempt.asked, *attempt.asked};
  return attempt.steps;
}

Examiner::Examiner(const Scene& scene, Question question)
    : scene_(scene), question_(std::move(question)), reference_(scene) {}

Rows Examiner::counted(const Rows& columns) const { return columns(question_.columns, Eigen::all); }

Trajectory Examiner::solve(const Way& way, const StepsOrAccuracy& resolution,
                           const std::vector<double>& times, double budget) const {
  const Setup setup{.resolution = resolution, .grading = way.grading};
  return way.scheme->solve(scene_.problem, resolution_of(setup, scene_.problem.end),
                           {.budget = budget, .at = times});
}

std::vector<double> Examiner::compared_times(const Way& way, const StepsOrAccuracy& resolution,
                                             int watched) const {
  const double end = scene_.problem.end;
  if (question_.kind.norm == Norm::end) return {end};
  if (way.chooses_steps()) return watched_times(scene_.problem, watched);
  return watched_times({.end = end, .steps = std::get<int>(resolution), .grading = way.grading}, watched);
}

Attempt Examiner::examine(const Way& way, const StepsOrAccuracy& resolution, int watched, double budget) {
  const bool at_end = question_.kind.norm == Norm::end;
  const auto times = compared_times(way, resolution, watched);
  Attempt attempt;
  const auto start = std::chrono::steady_clock::now();
  const auto path = solve(way, resolution, times, budget);
  attempt.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto* asked = std::get_if<Accuracy>(&resolution)) {
    attempt.asked = asked->relative;
    attempt.steps = static_cast<int>(path.steps);
  } else {
    attempt.steps = std::get<int>(resolution);
  }
  attempt.ending = ending_of(scene_.problem, path);
  if (path.ending != Ending::finished) return attempt;
  attempt.values = counted(columns_of(scene_.outputs, path));
  at_end ? judge_end(attempt) : judge_all(path.times, attempt);
  constexpr double nearly = 1e-9;
  if (attempt.trivial < nearly && is_constant()) attempt.trivial = std::numeric_limits<double>::infinity();
  if (!at_end && !way.chooses_steps()) {
    const Grid grid{.end = scene_.problem.end, .steps = attempt.steps, .grading = way.grading};
    attempt.error = std::max(attempt.error, hidden_motion(grid));
  }
  attempt.within = attempt.error + reference_bound() <= question_.accuracy && attempt.error < attempt.trivial;
  return attempt;
}

bool Examiner::same_values(const Way& one, const Way& other, int steps) {
  const auto times = watched_times({.end = scene_.problem.end, .steps = steps, .grading = one.grading});
  const double budget = std::numeric_limits<double>::infinity();
  const auto first = solve(one, steps, times, budget), second = solve(other, steps, times, budget);
  return first.ending == Ending::finished && second.ending == Ending::finished &&
         first.times == second.times &&
         columns_of(scene_.outputs, first) == columns_of(scene_.outputs, second);
}

void Examiner::solve_to_end(const Way& way, const StepsOrAccuracy& resolution) const {
  static_cast<void>(solve(way, resolution, {scene_.problem.end}, std::numeric_limits<double>::infinity()));
}

void Examiner::know_reference(int times) {
  reference_.at(watched_times({.end = scene_.problem.end, .steps = times}));
}

Rows Examiner::finite_reference(const std::vector<double>& times) {
  Rows reference = counted(reference_.at(times));
  if (const auto column = first_overflow(reference)) {
    throw std::runtime_error(
        fmt::format("the solution overflows at t = {:.6g}: nothing can be compared with it",
                    times[static_cast<std::size_t>(*column)]));
  }
  return reference;
}

void Examiner::judge_all(const std::vector<double>& times, Attempt& attempt) {
  const Rows reference = finite_reference(times);
  const Rows by = divisors(question_.kind.scale, times, reference);
  Eigen::Index row = 0, column = 0;
  attempt.error = (attempt.values - reference).cwiseAbs().cwiseQuotient(by).maxCoeff(&row, &column);
  attempt.trivial = trivial_error(Norm::maximum, times, reference, by);
  attempt.column = question_.columns[static_cast<std::size_t>(row)];
  attempt.time = times[static_cast<std::size_t>(column)];
}

bool Examiner::is_constant() {
  if (is_constant_) return *is_constant_;
  constexpr int steps = 64;
  constexpr double rounding = 1e-15;
  const auto times = watched_times(scene_.problem, steps);
  const Rows values = finite_reference(times), unknown = counted(reference_.bounds(times));
  const Rows first = values.col(0).replicate(1, values.cols());
  const Rows least = unknown + unknown.col(0).replicate(1, unknown.cols()) + rounding * first.cwiseAbs();
  return is_constant_.emplace(((values - first).cwiseAbs().array() <= least.array()).all());
}

// At times that no grid has: evenly spread, and in powers towards the start and each jump.
const Examiner::Motion& Examiner::motion() {
  if (motion_) return *motion_;
  constexpr int evenly = 64;
  auto times = watched_times(scene_.problem, evenly);
  const Rows values = finite_reference(times);
  const Rows by = divisors(question_.kind.scale, times, values);
  Rows moved = Rows::Zero(values.rows(), values.cols());
  for (Eigen::Index c = 1; c < values.cols(); ++c) {
    moved.col(c) =
        moved.col(c - 1) +
        (values.col(c) - values.col(c - 1)).cwiseAbs().cwiseQuotient(by.col(c).cwiseMax(by.col(c - 1)));
  }
  return motion_.emplace(Motion{std::move(times), std::move(moved)});
}

// Half of the motion of a column within one step, where that is most of all its motion; 0 where there is no
// such step. A maximum over the steps of a grid does not see it. A solution that moves as t^g, g being the
// smallest order, has the part h^g of its motion within a first step h (of an interval 1), which is no
// transient: most is half of what is left, too, and nine tenths at most.
double Examiner::hidden_motion(const Grid& grid) {
  const auto& times = motion().times;
  const auto& moved = motion().moved;
  double hidden = 0.0, order = 1.0;
  for (const auto& component : scene_.problem.components) {
    if (component.order > 0.0) order = std::min(order, component.order);
  }
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    const auto row = moved.row(i);
    const auto until = [&](double t) {
      const auto next = std::ranges::upper_bound(times, t);
      if (next == times.end()) return row[row.size() - 1];
      const auto c = static_cast<Eigen::Index>(next - times.begin());
      const double part = (t - *(next - 1)) / (*next - *(next - 1));
      return row[c - 1] + part * (row[c] - row[c - 1]);
    };
    // Only the step in which the column comes to the half of its way can have more than half of it.
    const double whole = row[row.size() - 1];
    Eigen::Index half = 1;
    while (half < row.size() - 1 && row[half] < 0.5 * whole) ++half;
    const double t = times[static_cast<std::size_t>(half)];
    const double n = grid.steps * std::pow(t / grid.end, 1.0 / grid.grading);
    const int last = std::clamp(static_cast<int>(std::ceil(n)), 1, grid.steps);
    const double within = until(grid.time(last)) - until(grid.time(last - 1));
    constexpr double most = 0.9;
    const double part_of_power = std::pow((grid.time(last) - grid.time(last - 1)) / grid.end, order);
    if (within > std::min(most, 0.5 * (1.0 + part_of_power)) * whole) hidden = std::max(hidden, 0.5 * within);
  }
  return hidden;
}

void Examiner::judge_end(Attempt& attempt) {
  const auto& [reference, by, trivial, bound] = at_end();
  const Vec difference = attempt.values.rightCols(1) - reference.rightCols(1);
  Eigen::Index row = 0;
  attempt.error = difference.cwiseAbs().cwiseQuotient(by.rightCols(1)).maxCoeff(&row);
  attempt.trivial = trivial;
  attempt.column = question_.columns[static_cast<std::size_t>(row)];
  attempt.time = scene_.problem.end;
  if (difference.size() == 1) attempt.signed_error = difference[0];
}

// The scale of a value needs those shortly before it, what is trivial the first one.
const Examiner::AtEnd& Examiner::at_end() {
  if (at_end_) return *at_end_;
  constexpr int nearby = 64;
  const double end = scene_.problem.end;
  std::vector<double> times{0.0};
  for (int i = 0; i <= nearby; ++i) times.push_back(end * (9 * nearby + i) / (10 * nearby));
  Rows reference = finite_reference(times);
  Rows by = divisors(question_.kind.scale, times, reference);
  const double trivial = trivial_error(Norm::end, times, reference, by);
  const Vec unknown = reference_.bounds({end})(question_.columns, 0);
  const double bound = unknown.cwiseQuotient(by.rightCols(1)).maxCoeff();
  return at_end_.emplace(AtEnd{std::move(reference), std::move(by), trivial, bound});
}

}  // namespace fde
