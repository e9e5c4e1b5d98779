// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Theoretical rates of one scheme, defined beside the scheme. A component of order g contributes its smooth
// rate and, for each power t^p in its expansion at t = 0 (Smoothness), the rate q(g, p) of that power on a
// uniform grid, infinity where the scheme is exact for it. The error of a power comes from the first steps.
// On a graded grid the first step is t_1 = end / N^grading, so the rate is grading * q, at most the smooth
// rate; the optimal grading is the smooth rate over q (Brunner 1985; for L1 Stynes, O'Riordan & Gracia 2017).
// Algebraic rows hold exactly at every step and contribute nothing.
struct RateTheory {
  std::function<double(double g)> smooth;
  double (*end)(double g, double p);         // q at a fixed time
  double (*first_step)(double g, double p);  // q at t_1
  // Whether f is evaluated inside the steps, where it does not jump: after a jump only the new expansion has
  // an error. Other schemes take the mean of both one-sided values at the jump, an error O(1) in f.
  bool evaluates_inside_steps = false;
  // The powers of h after the smooth rate in the expansion of the error; nullptr: not known.
};

// The rates of single powers that several theories share. `exact_power`: a rule has no error for it.
inline constexpr double exact_power = std::numeric_limits<double>::infinity();

// Rules that interpolate f = D^g y linearly are exact for f ~ t^r, r = p - g = 0 and 1; any other r has the
// error zeta(-r) h^(1+r) times the kernel at a fixed time, and h^(g+r) at the first step.
double end_rate_of_interpolated_f(double g, double p);
double first_step_rate_of_interpolated_f(double g, double p);

// Rules that interpolate y by polynomials are exact for p = 0 and 1; any other t^p has the error h^(1+p-g) at
// a fixed time and h^p at the first step.
double end_rate_of_interpolated_y(double g, double p);
double first_step_rate_of_interpolated_y(double g, double p);

// The rate of a scheme: the smallest of all contributions, for grids with this grading exponent.
//
// In a two-sided problem the powers of a right row are those of end - t. Then Norm::end means fixed times
// inside the interval. At t = end itself a left row of order g that depends on a right row ~ (end - t)^p has
// an error h^(g+p), which is not counted. At t_1 a right row or an unknown initial value has the error of the
// whole interval: for Norm::first_step the result is a lower bound.
double rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness, double grading,
            Norm norm);

// The rate of a scheme that solves the split problem (order_splitting.hpp): all links count at a fixed time,
// only the original components count in the first steps.
double split_rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness,
                  const OrderSplitting& links, double grading, Norm norm);

// Scheme::expected_rate of a scheme with this theory, which must outlive it; of a scheme that solves the
// split problem.
ExpectedRate expected_rate(const RateTheory& theory);
ExpectedRate expected_rate(const RateTheory& theory, OrderSplitting (*splitting)(const Problem& problem));

// The theoretical rate of a scheme, Scheme::expected_rate; nullopt where it has none, or where `smoothness`
// does not give the powers of every component. With unknown initial values it is that of an initial value
// problem, and at the first step at most that at the end.
std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, double grading, Norm norm);

// Whether all of these times before the end of the grid are grid times, to 1e-12 relative.
bool has_times(const Grid& grid, const std::vector<double>& times);

// The theoretical rate on this grid: at most 1 where a jump is inside a step, at most 2, and next to it 1 +
// the order, where a kink is.
std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, const Grid& grid, Norm norm);

// The powers of t in the solution at t = 0 that follow from the orders alone, for a right-hand side smooth in
// t and y: all gamma_i + (sums of orders and integers), and t for orders above 1. For a problem in multi-term
// form they follow from the orders of the terms, with forces that depend on u.
Smoothness generic_smoothness(const Problem& problem);

// The smallest grading exponent with which the scheme has its largest rate in the maximum norm for
// generic_smoothness(problem): the smooth rate over the rate at the start (rates.hpp), rounded up to
// hundredths, at most 10. 1 where the scheme refuses the problem or graded grids, or has no rate, and for
// problems with right derivatives. It depends on the orders only, not on the solution.
double optimal_grading(const Scheme& scheme, const Problem& problem);

}  // namespace fde
