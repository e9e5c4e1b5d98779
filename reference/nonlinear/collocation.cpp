// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/reference/nonlinear/collocation/piecewise_solution.hpp"
#include "fdebench/reference/nonlinear/collocation/residual.hpp"
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"
#include "fdebench/reference/nonlinear/event_windows.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/shooting.hpp"

namespace fde::reference {

namespace {

constexpr double window = 10.0;    // ratio of times: the larger errors of earlier panels have decayed
constexpr double started = 1e-12;  // relative to the end: the errors of the first steps have decayed

// The largest differences on the panel, next to no event.
Vec difference_on(const Panel& panel, const PiecewiseSolution& solution, const PiecewiseSolution& other,
                  const EventWindows& events) {
  constexpr int samples = 40;
  Vec largest = Vec::Zero(panel.values.cols());
  for (int k = 1; k <= samples; ++k) {
    const double t = k == samples ? panel.to : panel.from + panel.length() * k / samples;
    if (!events.contains(t)) largest = largest.cwiseMax((solution.at(t) - other.at(t)).cwiseAbs());
  }
  return largest;
}

// The largest differences from the second method on each panel, at the ends of the steps of that method.
std::vector<Vec> differences_to(const DiffusiveSolution& second, const PiecewiseSolution& solution,
                                const EventWindows& events) {
  const auto& panels = solution.panels();
  std::vector<Vec> largest(panels.size(), Vec::Zero(panels.front().values.cols()));
  for (std::size_t k = 0; k < second.times.size(); ++k) {
    const double t = second.times[k];
    if (t >= started * panels.back().to && !events.contains(t)) {
      Vec& on_panel = largest[solution.panel_of(t)];
      on_panel = on_panel.cwiseMax((second.values[k] - solution.at(t)).cwiseAbs());
    }
  }
  return largest;
}

// Whether the panel is one of the first after a jump, compared with the later time `now`.
bool has_decayed(const Problem& problem, const Panel& panel, double now) {
  const double jump = last_jump(problem, panel.from);
  return jump > 0.0 && panel.to - jump < (now - jump) / window;
}

// Mean rate of change of each component on a panel.
Vec slope_on(const Panel& panel) {
  return (panel.values.colwise().maxCoeff() - panel.values.colwise().minCoeff()).transpose() / panel.length();
}

// An estimate of the error of a solution on each of its panels: twice the larger of its differences from
// another resolution and from a second method, plus an allowance for the rounding of f, which all three
// share. As errors change sign, the largest difference over the last decade of time, and of the time since a
// jump, counts; differences from the second method on earlier panels, as errors of phase, count in proportion
// to the rate of change of the solution.
std::vector<Vec> error_estimates(const PiecewiseSolution& solution, const PiecewiseSolution& other,
                                 const DiffusiveSolution& second, const EventWindows& events) {
  constexpr double safety = 2.0;
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const auto& panels = solution.panels();
  const auto to_second = differences_to(second, solution, events);
  std::vector<Vec> to_other, slopes, estimates;
  for (const Panel& panel : panels) {
    to_other.push_back(difference_on(panel, solution, other, events));
    slopes.push_back(slope_on(panel));
  }
  for (std::size_t last = 0; last < panels.size(); ++last) {
    const Vec slope = slopes[last].cwiseMax(slopes[last > 0 ? last - 1 : last]);
    Vec difference = to_other[last].cwiseMax(to_second[last]);
    for (std::size_t k = solution.panel_of(panels[last].from / window); k < last; ++k) {
      if (has_decayed(solution.problem(), panels[k], panels[last].from)) continue;
      const Vec share = (slope.array() / (slopes[k].array() + std::numeric_limits<double>::min())).min(1.0);
      difference = difference.cwiseMax(to_other[k]).cwiseMax(to_second[k].cwiseProduct(share));
    }
    estimates.emplace_back(safety * difference + rounding * panels[last].size);
  }
  return estimates;
}

void require_supported_resets(const Problem& problem) {
  if (problem.resets.empty() || (!is_two_sided(problem) && problem.delays.lags.empty())) return;
  throw std::runtime_error(
      "the two methods of a reference take events that set unknowns only without delays and values at both "
      "ends");
}

// Both methods solve linear systems for all values of a panel or a step: dense ones of 100 unknowns in a
// minute, and in eight times as long for 200; sparse ones of 400 points of a line in half a minute.
void require_affordable(const Problem& problem) {
  constexpr Eigen::Index most_dense = 200, most_sparse = 400;
  if (problem.size() <= most_dense) return;
  const auto most = has_sparse_jacobian(problem) ? most_sparse : most_dense;
  if (problem.size() <= most) return;
  throw std::runtime_error(
      fmt::format("the two methods of a reference take up to {} unknowns, not {}", most, problem.size()));
}

// Lengths of the first panel and the first step, and PanelOptions::negligible_before, relative to the end.
struct InitialLengths {
  double panel = 1e-32, step = 1e-20, weightless = 1e-18;
};

// The length, relative to the end, of a first panel on which y hardly changes: there Newton's method, which
// starts from y(0), finds the root that continues it. A solution of D^g y = -k y^2 with a small g is far from
// y(0) soon after 0, and the equations of a longer panel have other roots. Not below 1e-290: the residual
// shows whether that is short enough.
double length_of_small_change(const Problem& problem) {
  constexpr double small = 0.1, shortest = 1e-290;
  Matrix jacobian(problem.size(), problem.size());
  double length = 1.0;
  if (!evaluate_jacobian(problem, 0.0, taylor_part(problem, 0.0), jacobian) || !jacobian.allFinite())
    return length;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.component(i).order;
    const double rate = jacobian.row(i).cwiseAbs().sum() / std::tgamma(order + 1.0);
    if (order > 0.0 && rate > 0.0)
      length = std::min(length, std::pow(small / rate, 1.0 / order) / problem.end);
  }
  return std::max(length, shortest);
}

// A solution starts like t^g, g the smallest order, and the first panel approximates it by a polynomial. That
// error is below rounding if the panel is short enough, or it decays within some decades: before the first
// step of a grid, which is at least N^-10 of the end, 6e-58 for 2^19 steps. With multipliers it must be below
// rounding, since the constraint propagates it to all components. For the second method, whose constraint
// determines the reaction, t^(2 g) remains.
InitialLengths initial_lengths(const Problem& problem) {
  constexpr double rounding = 1e-17, before_grids = 1e-66, early = 1e-6, shortest = 1e-270;
  const double order = smallest_order(problem);
  InitialLengths usual;
  const double unseen = std::min(usual.panel, std::pow(rounding, 1.0 / order));
  if (!has_algebraic_rows(problem)) {
    usual.panel = std::min(std::max(unseen, before_grids), length_of_small_change(problem));
    return usual;
  }
  const InitialLengths starts{.panel = unseen,
                              .step = std::min(usual.step, std::pow(rounding, 0.5 / order)),
                              .weightless = std::min(usual.weightless, std::pow(early, 1.0 / order))};
  if (starts.panel < shortest) {
    throw std::runtime_error(
        fmt::format("collocation: takes no order below {:.2g} with algebraic rows, one is {:.3g}",
                    std::log(rounding) / std::log(shortest), order));
  }
  return starts;
}

// Bound of the initial values: infinite for the multipliers, which are in no algebraic row, or, where the
// algebraic rows do not hold at t = 0, for the unknowns of all algebraic rows.
Vec initial_bound(const Problem& problem) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), rounding = 1e-14;
  Vec bound = Vec::Zero(problem.size());
  if (!has_algebraic_rows(problem)) return bound;
  const Vec start = taylor_part(problem, 0.0), f = rhs_at(problem, 0.0, start);
  const double size = std::max(1.0, start.lpNorm<Eigen::Infinity>());
  const auto rows = algebraic_rows(problem);
  const bool held = std::ranges::all_of(rows, [&](auto i) { return std::abs(f[i]) <= rounding * size; });
  for (const auto i : held ? multipliers(problem) : rows) bound[i] = infinity;
  return bound;
}

// The problem as one run of one method solves it. With delays it looks back at that run, so that an error of
// one is none of another.
struct OwnProblem {
  explicit OwnProblem(const Problem& given) : bound(given), problem(bound.problem()) {
    // Polynomials resolve a kink no better than a jump.
    problem.jump_times = breaking_points(problem);
    if (!given.delays.lags.empty()) looking_back = &bound;
  }
  BoundProblem bound;
  Problem problem;
  BoundProblem* looking_back = nullptr;
};

PiecewiseSolution collocation(const OwnProblem& own, int points, double shortest, double tolerance) {
  const InitialLengths starts = initial_lengths(own.problem);
  return {own.problem,
          {.points = points,
           .first_panel = shortest * starts.panel,
           .first_after_jump = shortest * first_after_jump,
           .tolerance = tolerance,
           .negligible_before = starts.weightless,
           .looking_back = own.looking_back}};
}

DiffusiveSolution diffusive(const OwnProblem& own) {
  const InitialLengths starts = initial_lengths(own.problem);
  DiffusiveOptions options{
      .first_step = starts.step, .negligible_before = starts.weightless, .looking_back = own.looking_back};
  // Within a step y is less accurate than at its end, and f, or the time of an event, depends on it.
  constexpr double within_steps = 1e-13;
  if (own.looking_back != nullptr || !own.problem.resets.empty()) options.tolerance = within_steps;
  return diffusive_solution(own.problem, options);
}

// A problem with conditions at both ends as one of the methods after the other solves it. Each finds the
// unknown initial values by its own runs, from those of the method before, so that their differences contain
// the condition of the problem.
class CompleteProblems {
 public:
  explicit CompleteProblems(const Problem& given) : given_(given) {}

  // The initial value problem of a method, of which `end` gives y(end). Throws std::runtime_error if it does
  // not find the initial values, or if they are not those of the method before.
  template <class End>
  Problem found_by(const End& end) {
    if (!is_solved_by_shooting(given_)) return given_;
    const EndOfRun run = [&](const Problem& complete) -> std::optional<Vec> {
      try {
        return end(OwnProblem(complete));
      } catch (const std::runtime_error&) {
        return std::nullopt;
      }
    };
    if (missing_.converged && !are_determined(given_, missing_, run)) {
      throw std::runtime_error(
          "two methods: the values at the end do not determine the missing initial values");
    }
    constexpr Tolerance noise{1e-14, 0.0};
    missing_ = find_missing_values(given_, run, noise, std::move(missing_));
    if (std::isinf(missing_.missed)) {
      throw std::runtime_error(
          "two methods: with 0 for the missing initial values they do not reach the end");
    }
    if (!missing_.converged) {
      throw std::runtime_error(fmt::format(
          "two methods: Newton's method did not converge for the missing initial values: the values "
          "at the end are missed by {:.2g}",
          missing_.missed));
    }
    return with_initial_values(given_, missing_.values);
  }

 private:
  const Problem& given_;
  MissingValues missing_{};
};

// The panels, which end where it begins to be unknown whether y has jumped.
PanelTable table_of(const PiecewiseSolution& solution, const std::vector<Vec>& estimates,
                    const EventWindows& events) {
  PanelTable table;
  const auto add = [&](std::size_t number, double from, double to) {
    const Panel& panel = solution.panels()[number];
    table.panels.push_back({from, to, solution.legendre_values(panel, from, to),
                            estimates[number] + events.jump_within(from, to)});
  };
  for (std::size_t number = 0; const Panel& panel : solution.panels()) {
    const auto cut = events.beginning(panel.from, panel.to);
    if (cut) add(number, panel.from, *cut);
    add(number++, cut.value_or(panel.from), panel.to);
  }
  return table;
}

PanelTable table_of(const Problem& problem, const CollocationOptions& options) {
  constexpr int many = 20, fewer = 16;
  constexpr double usual = 1.0, longer = 3.0;  // first panels
  CompleteProblems problems(problem);
  const auto by_collocation = [&](int points, double shortest) {
    return problems.found_by([&](const OwnProblem& own) {
      return collocation(own, points, shortest, options.tolerance).at(own.problem.end);
    });
  };
  const Problem of_first = by_collocation(many, usual), of_again = by_collocation(fewer, longer);
  const Problem of_last =
      problems.found_by([](const OwnProblem& own) { return diffusive(own).values.back(); });
  const OwnProblem first(of_first), again(of_again), last(of_last);
  const auto solution = collocation(first, many, usual, options.tolerance);
  require_small_residual(solution.problem(), solution);
  const auto other = collocation(again, fewer, longer, options.tolerance);
  const auto second = diffusive(last);
  const EventWindows events(solution, other, second);
  return table_of(solution, error_estimates(solution, other, second, events), events);
}

// The bound of the initial values, where unknown ones have that of the first panel.
Vec initial_bound(const Problem& problem, const PanelTable& table) {
  Vec bound = initial_bound(BoundProblem(with_some_initial_values(problem)).problem());
  for (Eigen::Index i = 0; i < problem.size(); ++i)
    if (problem.component(i).initial.empty()) bound[i] = table.panels.front().bound[i];
  return bound;
}

// A bound above all values says that nothing is known. Next to 0 rounding is as large as the values, and
// unknowns of algebraic rows may be unbounded.
void require_known_values(const PanelTable& table) {
  constexpr double far = 100.0;
  double largest = 0.0;
  for (const auto& panel : table.panels) largest = std::max(largest, panel.values.lpNorm<Eigen::Infinity>());
  for (const auto& panel : table.panels) {
    const bool at_start = panel.to < started * table.panels.back().to;
    if (at_start || panel.bound.maxCoeff() <= far * largest) continue;
    throw std::runtime_error(fmt::format(
        "the two methods of a reference differ by {:.2g} at t = {:.6g}, where values are up to {:.2g}",
        panel.bound.maxCoeff(), panel.to, largest));
  }
}

}  // namespace

Reference reference_from_table(PanelTable table, const Problem& problem) {
  require_known_values(table);
  Vec at_start = initial_bound(problem, table);
  return reference_from_panels(std::move(table), std::move(at_start));
}

PanelTable reference_table(const Problem& problem, const CollocationOptions& options) {
  require_supported(with_some_initial_values(problem));
  require_affordable(problem);
  require_supported_resets(problem);
  return table_of(problem, options);
}

Reference reference_solution(const Problem& problem, const CollocationOptions& options) {
  return reference_from_table(reference_table(problem, options), problem);
}

}  // namespace fde::reference
