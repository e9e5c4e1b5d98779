#include "fdebench/schemes/stepping/rates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fde {
namespace {

constexpr double exact = std::numeric_limits<double>::infinity();

bool is_zero_or_one(double power) { return same_order(power, 0.0) || same_order(power, 1.0); }

double trapezoidal_end(double g, double p) { return is_zero_or_one(p - g) ? exact : 1 + p - g; }
double trapezoidal_first(double g, double p) {
  if (is_zero_or_one(p - g)) return exact;
  return p;
}

// The predictor takes f constant: where f starts like t, it has the error h^(1+g), and y has h^g times that.
double predictor_corrector_first(double g, double p) {
  return same_order(p - g, 1.0) ? 2 * g + 1 : trapezoidal_first(g, p);
}

// Backward Euler is exact for t.
double grunwald_letnikov_first(double g, double p) {
  if (g == 1.0 && same_order(p, 1.0)) return exact;
  return p;
}

double l1_first(double /*g*/, double p) {
  if (is_zero_or_one(p)) return exact;
  return p;
}

double l1_end(double g, double p) { return is_zero_or_one(p) ? exact : 1 + p - g; }

double l2_1_sigma_first(double g, double p) { return same_order(p, 2.0) ? 2 + g : l1_first(g, p); }

double smallest_over_powers(double (*contribution)(double g, double p), const Problem& problem,
                            const Smoothness& smoothness) {
  double rate = exact;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    for (const double p : smoothness.powers[i])
      rate = std::min(rate, contribution(problem.components[i].order, p));
  }
  return rate;
}

bool is_hidden(const Smoothness& smoothness, std::size_t i) {
  return std::ranges::find(smoothness.hidden, static_cast<Eigen::Index>(i)) != smoothness.hidden.end();
}

double smallest_shown_order(const Problem& problem, const Smoothness& smoothness) {
  double order = exact;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    if (!is_hidden(smoothness, i)) order = std::min(order, problem.components[i].order);
  }
  return order;
}

// The rate at t_1. The error of a hidden component enters the other components with a factor h^integrated.
double smallest_at_first_step(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness,
                              double integrated) {
  double rate = exact;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const double later = is_hidden(smoothness, i) ? integrated : 0.0;
    for (const double p : smoothness.powers[i])
      rate = std::min(rate, later + theory.first_step(problem.components[i].order, p));
  }
  return rate;
}

// The rate at jumps of f at a time t_m. Interpolation through the mean of both one-sided values has an error
// O(1) in f, O(h^order) in y at t_(m+1). If f is evaluated between steps, the row continues like
// (t - t_m)^order, and rows that depend on it like its fractional integral.
double smallest_at_jumps(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness) {
  double rate = exact;
  for (const auto i : smoothness.jumps) {
    const auto& component = problem.components[static_cast<std::size_t>(i)];
    if (algebraic(component)) continue;
    if (!theory.evaluates_inside_steps) {
      rate = std::min(rate, component.order);
      continue;
    }
    rate = std::min(rate, theory.first_step(component.order, component.order));
    for (const auto& [order, initial, side] : problem.components)
      rate = std::min(rate, theory.first_step(order, order + component.order));
  }
  return rate;
}

}  // namespace

const RateTheory trapezoidal_theory{[](double) { return 2.0; }, trapezoidal_end, trapezoidal_first};

const RateTheory predictor_corrector_theory{[](double g) { return std::min(2.0, 1 + g); }, trapezoidal_end,
                                            predictor_corrector_first};

const RateTheory l1_theory{[](double g) { return 2 - g; }, l1_end, l1_first};

const RateTheory l1_2_theory{[](double g) { return 3 - g; }, l1_end, l1_first};

const RateTheory l2_1_sigma_theory{[](double) { return 2.0; }, l1_end, l2_1_sigma_first, true};

const RateTheory grunwald_letnikov_theory{[](double) { return 1.0; }, [](double, double) { return exact; },
                                          grunwald_letnikov_first};

double rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness, double grading,
            Norm norm) {
  const double first_step = grading * smallest_at_first_step(theory, problem, smoothness,
                                                             smallest_shown_order(problem, smoothness));
  if (norm == Norm::first_step && !is_two_sided(problem)) return first_step;
  double end = grading * smallest_over_powers(theory.end, problem, smoothness);
  for (const auto& component : problem.components) {
    if (!algebraic(component)) end = std::min(end, theory.smooth(component.order));
  }
  // Jumps are at times of the uniform grid; a jump inside a step causes an error O(h).
  if (grading != 1.0 && !smoothness.jumps.empty()) end = std::min(end, 1.0);
  if (norm == Norm::end) return end;
  if (norm == Norm::first_step) return std::min(end, first_step);
  return std::min({end, first_step, smallest_at_jumps(theory, problem, smoothness)});
}

double split_rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness,
                  const OrderSplitting& links, double grading, Norm norm) {
  const Problem all = split(problem, links);
  const Smoothness starts = split(problem, smoothness, links);
  if (norm == Norm::end) return rate(theory, all, starts, grading, norm);
  Problem seen;
  Smoothness seen_starts{.powers = {}, .hidden = smoothness.hidden};
  for (std::size_t i = 0, first = 0; i < links.size(); first += links[i++].size()) {
    seen.components.push_back(all.components[first]);
    seen_starts.powers.push_back(starts.powers[first]);
  }
  const double first_step =
      grading * smallest_at_first_step(theory, seen, seen_starts, smallest_shown_order(problem, smoothness));
  if (norm == Norm::first_step) return first_step;
  return std::min({rate(theory, all, starts, grading, Norm::end), first_step,
                   smallest_at_jumps(theory, problem, smoothness)});
}

std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, double grading, Norm norm) {
  const bool declared = smoothness.powers.size() == problem.components.size();
  if (!scheme.expected_rate || !declared) return std::nullopt;
  return scheme.expected_rate(problem, smoothness, grading, norm);
}

bool has_breaking_points(const Problem& problem, const Grid& grid) {
  constexpr double rounding = 1e-12;
  return std::ranges::all_of(problem.jumps, [&](double t) {
    return t >= grid.end || std::abs(grid.time(grid.number(t)) - t) <= rounding * t;
  });
}

std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, const Grid& grid, Norm norm) {
  const auto expected = theoretical_rate(scheme, problem, smoothness, grid.grading, norm);
  return expected && !has_breaking_points(problem, grid) ? std::min(*expected, 1.0) : expected;
}

}  // namespace fde
