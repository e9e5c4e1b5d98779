#pragma once

#include <functional>
#include <optional>

#include "stepping/scheme.hpp"
#include "stepping/splitting.hpp"

namespace fde {

// Theory of the rates of one scheme. A component of order g contributes its smooth rate and, for each power
// t^p with which it starts (Smoothness), what that power costs on a uniform grid; infinity where the scheme
// is exact for it. On a graded grid the first step is t_1 = end / N^grading, and all that a power costs,
// which comes from the first steps, is multiplied with the grading, up to the smooth rate: so the optimal
// grading is the smooth rate over the cost (Brunner 1985; for L1 Stynes, O'Riordan & Gracia 2017). Algebraic
// rows hold exactly at every step and contribute nothing.
struct RateTheory {
  std::function<double(double g)> smooth;
  double (*end)(double g, double p);         // at a fixed time
  double (*first_step)(double g, double p);  // at t_1
  // f is taken inside the steps, where it does not jump: what is left of a jump starts anew behind it. Others
  // take the mean of both sides there, which is off by a constant.
  bool between_steps = false;
};

// Piecewise linear interpolation of f = D^g y, which starts like t^r, r = p - g. Exact for r = 0 and 1;
// any other r leaves zeta(-r) h^(1+r), spread by the kernel, at a fixed time and h^(g+r) at the first step,
// beside h^2.
extern const RateTheory trapezoidal_theory;

// The same with f taken at a prediction by the rectangle rule: off by h, multiplied with h^g by the corrector
// (Diethelm, Ford & Freed 2004, theorem 3.2).
extern const RateTheory predictor_corrector_theory;

// Piecewise linear interpolation of y: h^(2-g); a power p other than 0 and 1 leaves h^(1+p-g) and at the
// first step h^p.
extern const RateTheory l1_theory;

// Piecewise quadratic interpolation of y: h^(3-g); the rest as for L1, as the first step has a line.
extern const RateTheory l1_2_theory;

// The same, exact at t* for t^2 too, with y at t* by linear interpolation: h^2, and h^(2+g) at the first
// step.
extern const RateTheory l2_1_sigma_theory;

// Backward Euler convolution quadrature: h; where y leaves its Taylor part like t^p, h^p at the first step.
extern const RateTheory grunwald_letnikov_theory;

// The rate of a scheme, the smallest of all contributions.
//
// In a two-sided problem each row starts at its own side, a right one at the end with powers of end - t. Then
// Norm::end speaks of fixed times inside the interval; at t = end itself a left row of order g driven by a
// right one that starts like (end - t)^p is off by h^(g+p), which is not counted. At t_1 a right row, or a
// unknown initial value, carries the error of the whole interval: Norm::first_step is a lower bound.
double rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness, double grading,
            Norm norm);

// The rate of a scheme that solves the split problem: all links count at a fixed time, only the original
// components are looked at in the first steps.
double split_rate(const RateTheory& theory, const Problem& problem, const Smoothness& smoothness,
                  const Links& links, double grading, Norm norm);

// The rate that theory expects of a scheme, as Scheme::expected_rate has it; nullopt: there is none, or how
// the solution starts is not declared.
std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, double grading, Norm norm);

// Whether every jump of the right-hand side before the end is at a time of the grid, up to rounding.
bool meets_jumps(const Problem& problem, const Grid& grid);

// The rate on this grid: at most 1 where a jump falls inside a step.
std::optional<double> theoretical_rate(const Scheme& scheme, const Problem& problem,
                                       const Smoothness& smoothness, const Grid& grid, Norm norm);

}  // namespace fde
