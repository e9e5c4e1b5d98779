// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/rates.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/problem/chain.hpp"

namespace fde {

namespace {

bool is_zero_or_one(double power) { return same_order(power, 0.0) || same_order(power, 1.0); }

double smallest_over_powers(double (*contribution)(double g, double p), const Problem& problem,
                            const Smoothness& smoothness) {
  double rate = exact_power;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    for (const double p : smoothness.powers[i])
      rate = std::min(rate, contribution(problem.components[i].order, p));
  }
  return rate;
}

bool is_unmeasured(const Smoothness& smoothness, std::size_t i) {
  return std::ranges::find(smoothness.unmeasured, static_cast<Eigen::Index>(i)) !=
         smoothness.unmeasured.end();
}

double smallest_measured_order(const Problem& problem, const Smoothness& smoothness) {
  double order = exact_power;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    if (!is_unmeasured(smoothness, i)) order = std::min(order, problem.components[i].order);
  }
  return order;
}

// The rate at t_1. The error of an unmeasured component enters the other components with a factor
// h^integrated.
double smallest_at_first_step(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness,
                              double integrated) {
  double rate = exact_power;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const double later = is_unmeasured(smoothness, i) ? integrated : 0.0;
    for (const double p : smoothness.powers[i])
      rate = std::min(rate, later + theory.first_step(problem.components[i].order, p));
  }
  return rate;
}

// The rate at a fixed time behind the breaking points of f, which are grid times. A jump is integrated by the
// mean of both one-sided values like a trapezoid, with an error O(h^2).
double smallest_behind_breaking_points(const RateTheory& theory, const Problem& problem,
                                       const Smoothness& smoothness) {
  double rate = exact_power;
  for (const auto& [row, power] : smoothness.breaking_points) {
    const double order = problem.component(row).order;
    if (problem.is_algebraic(row)) continue;
    const bool is_mean = power == 0.0 && !theory.evaluates_inside_steps;
    rate = std::min(rate, is_mean ? 2.0 : theory.end(order, order + power));
  }
  return rate;
}

// The rate where breaking points are inside steps, or the scheme does not know them.
double smallest_inside_steps(const Problem& problem, const Smoothness& smoothness, Norm norm) {
  double rate = exact_power;
  for (const auto& [row, power] : smoothness.breaking_points) {
    if (problem.is_algebraic(row) || norm == Norm::first_step) continue;
    const double before_end = norm == Norm::maximum ? std::min(1.0, problem.component(row).order) : 1.0;
    rate = std::min(rate, before_end + power);
  }
  return rate;
}

// The rate next to breaking points of f at a time t_m in the maximum norm. Interpolation through the mean of
// both one-sided values has an error O(1) in f, O(h^order) in y at t_(m+1). With order 1, whose kernel is
// constant, it is of opposite signs in the two steps beside t_m and cancels, but for the O(h) in y at t_m
// that other rows integrate. If f is evaluated between steps, the row continues like (t - t_m)^order, and
// rows that depend on it like its fractional integral.
double smallest_at_breaking_points(const RateTheory& theory, const Problem& problem,
                                   const Smoothness& smoothness) {
  double rate = exact_power;
  for (const auto& [row, power] : smoothness.breaking_points) {
    const auto& component = problem.component(row);
    if (is_algebraic(component)) continue;
    if (power > 0.0) {
      rate = std::min(rate, theory.first_step(component.order, component.order + power));
      continue;
    }
    if (!theory.evaluates_inside_steps) {
      const bool cancels = component.order == 1.0;
      if (!cancels) rate = std::min(rate, component.order);
      for (const auto& other : problem.components)
        if (cancels && !is_algebraic(other)) rate = std::min(rate, 1.0 + other.order);
      continue;
    }
    rate = std::min(rate, theory.first_step(component.order, component.order));
    for (const auto& [order, initial, side] : problem.components)
      rate = std::min(rate, theory.first_step(order, order + component.order));
  }
  return rate;
}

constexpr double largest = 10.0;

Smoothness smoothness_of_rows(const Problem& problem) {
  std::vector<double> steps{1.0};
  for (const auto& component : problem.components) {
    if (!is_algebraic(component)) steps.push_back(component.order);
  }
  Smoothness smoothness;
  for (const auto& component : problem.components) {
    auto& powers = smoothness.powers.emplace_back();
    if (is_algebraic(component)) continue;
    std::vector<double> start{component.order};
    if (component.order > 1.0) start.push_back(1.0);
    powers = power_lattice(start, steps, component.order + 2.0);
  }
  return smoothness;
}

// The chains of all equations, with 1 for every initial value, so that no power is missing.
std::vector<Chain> started(const Problem& problem) {
  std::vector<Chain> chains;
  for (const auto& equation : problem.equations) {
    const Chain chain = chain_of(problem, equation);
    std::vector<double> initial = chain.initial();
    std::ranges::fill(initial, 1.0);
    chains.emplace_back(chain.leading(), chain.terms(), initial, chain.first_row());
  }
  return chains;
}

// Whether every row belongs to a multi-term equation and all have one leading order, as smoothness_of_chains
// needs.
bool only_chains(const Problem& problem, const std::vector<Chain>& chains) {
  Eigen::Index rows = 0;
  for (const auto& chain : chains) {
    if (!same_order(chain.leading().order, chains.front().leading().order)) return false;
    rows += chain.size();
  }
  return rows == problem.size();
}

// The smoothness up to the end of the problem: without breaking points that are later.
Smoothness up_to_end(const Problem& problem, Smoothness smoothness) {
  const auto is_before_end = [&](double t) { return t < problem.end; };
  if (std::ranges::none_of(breaking_points(problem), is_before_end) &&
      std::ranges::none_of(problem.delays.lags, is_before_end))
    smoothness.breaking_points.clear();
  return smoothness;
}

}  // namespace

double end_rate_of_interpolated_f(double g, double p) {
  return is_zero_or_one(p - g) ? exact_power : 1 + p - g;
}

double first_step_rate_of_interpolated_f(double g, double p) {
  if (is_zero_or_one(p - g)) return exact_power;
  return p;
}

double end_rate_of_interpolated_y(double g, double p) { return is_zero_or_one(p) ? exact_power : 1 + p - g; }

double first_step_rate_of_interpolated_y(double /*g*/, double p) {
  if (is_zero_or_one(p)) return exact_power;
  return p;
}

double rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness, double grading,
            Norm norm) {
  const double first_step = grading * smallest_at_first_step(theory, problem, smoothness,
                                                             smallest_measured_order(problem, smoothness));
  if (norm == Norm::first_step && !is_two_sided(problem)) return first_step;
  double end = grading * smallest_over_powers(theory.end, problem, smoothness);
  for (const auto& component : problem.components) {
    if (!is_algebraic(component)) end = std::min(end, theory.smooth(component.order));
  }
  end = std::min(end, smallest_behind_breaking_points(theory, problem, smoothness));
  // Breaking points are times of the uniform grid.
  if (grading != 1.0) end = std::min(end, smallest_inside_steps(problem, smoothness, norm));
  if (norm == Norm::end) return end;
  if (norm == Norm::first_step) return std::min(end, first_step);
  return std::min({end, first_step, smallest_at_breaking_points(theory, problem, smoothness)});
}

double split_rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness,
                  const OrderSplitting& links, double grading, Norm norm) {
  const Problem all = split_orders(problem, links);
  const Smoothness starts = split_orders(problem, smoothness, links);
  if (norm == Norm::end) return rate(theory, all, starts, grading, norm);
  Problem seen;
  Smoothness seen_starts{.powers = {}, .unmeasured = smoothness.unmeasured};
  for (std::size_t i = 0, first = 0; i < links.size(); first += links[i++].size()) {
    seen.components.push_back(all.components[first]);
    seen_starts.powers.push_back(starts.powers[first]);
  }
  const double first_step = grading * smallest_at_first_step(theory, seen, seen_starts,
                                                             smallest_measured_order(problem, smoothness));
  if (norm == Norm::first_step) return first_step;
  return std::min({rate(theory, all, starts, grading, Norm::end), first_step,
                   smallest_at_breaking_points(theory, problem, smoothness)});
}

ExpectedRate expected_rate(const RateTheory& theory) {
  return [&theory](const Problem& problem, const Smoothness& smoothness, double grading, Norm norm) {
    return rate(theory, problem, smoothness, grading, norm);
  };
}

ExpectedRate expected_rate(const RateTheory& theory, OrderSplitting (*splitting)(const Problem& problem)) {
  return
      [&theory, splitting](const Problem& problem, const Smoothness& smoothness, double grading, Norm norm) {
        return split_rate(theory, problem, smoothness, splitting(problem), grading, norm);
      };
}

std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, double grading, Norm norm) {
  const Smoothness seen = up_to_end(problem, smoothness);
  const bool declared = smoothness.powers.size() == problem.components.size();
  if (!scheme.expected_rate || !declared) return std::nullopt;
  if (!is_solved_by_shooting(problem)) return scheme.expected_rate(problem, seen, grading, norm);
  const auto rate = [&, complete = with_some_initial_values(problem)](Norm of) {
    return scheme.expected_rate(complete, seen, grading, of);
  };
  // The missing values have the error at the end.
  return std::min(rate(norm), rate(Norm::end));
}

bool has_times(const Grid& grid, const std::vector<double>& times) {
  constexpr double rounding = 1e-12;
  return std::ranges::all_of(times, [&](double t) {
    return t >= grid.end || std::abs(grid.time(grid.nearest_index(t)) - t) <= rounding * t;
  });
}

std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, const Grid& grid, Norm norm) {
  const auto expected = theoretical_rate(scheme, problem, smoothness, grid.grading, norm);
  if (!expected || has_times(grid, breaking_points(problem))) return expected;
  const double most = has_times(grid, problem.jump_times) ? exact_power : 1.0;
  return std::min({*expected, most, smallest_inside_steps(problem, smoothness, norm)});
}

Smoothness generic_smoothness(const Problem& problem) {
  const auto chains = started(problem);
  if (!chains.empty() && only_chains(problem, chains)) return smoothness_of_chains(chains);
  return smoothness_of_rows(problem);
}

double optimal_grading(const Scheme& scheme, const Problem& problem) {
  if (!scheme.expected_rate || has_right_rows(problem)) return 1.0;
  if (problem.conditions) return optimal_grading(scheme, with_some_initial_values(problem));
  if (unsupported_reason(scheme, problem, Grid{.end = problem.end, .steps = 2, .grading = 2.0})) return 1.0;
  const Smoothness smoothness = generic_smoothness(problem);
  const auto rate = [&](double grading) {
    return scheme.expected_rate(problem, smoothness, grading, Norm::maximum);
  };
  constexpr double rounding = 1e-9;
  const double best = rate(largest);
  double low = 1.0, high = largest;
  if (rate(low) >= best - rounding) return low;
  while (high - low > rounding) {  // bisection: the rate does not decrease with the grading
    const double middle = 0.5 * (low + high);
    (rate(middle) >= best - rounding ? high : low) = middle;
  }
  return std::ceil(100.0 * (high - 1e-6)) / 100.0;
}

}  // namespace fde
