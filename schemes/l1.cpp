// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"
#include "fdebench/schemes/history/weights/polylogarithm.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "fdebench/schemes/rules/interpolants/parabolas.hpp"
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {
namespace {

void subtract(In a, In b, Vec& difference) {
  for_each_row(a.size(), [from = a.data(), less = b.data(), to = difference.data()](Eigen::Index i) {
    to[i] = from[i] - less[i];
  });
}

// h^(-g)/Gamma(2-g) sum_{1<=j<=n} w_{n-j} (y_j - y_{j-1}) = f(t_n, y_n), orders g in (0, 1]; g = 1 is the
// backward Euler method.
Trajectory solve_l1(const Problem& problem, const Grid& grid, const Options& options) {
  return solve_implicit(
      problem, grid, options,
      {.tables = weight_tables(problem, families::l1),
       .known = [](double /*t*/, In convolved, In previous, In /*kappa*/,
                   Vec& known) { subtract(previous, convolved, known); },
       .sample = [](double /*t*/, In y, In previous, Vec& sample) { subtract(y, previous, sample); }});
}

// Piecewise linear interpolation of y: h^(2-g).
const RateTheory l1_rates{[](double g) { return 2 - g; }, end_rate_of_interpolated_y,
                          first_step_rate_of_interpolated_y};

// (1-zeta)^g K: the weights of the increments have the generating function
//   C = (1-zeta)^2/zeta (Li_(g-1) / 2 + Li_(g-2) / (2-g)),
// and K = Gamma(2-g) / ((1-zeta) C).
Kernel kernel_of_l1_2(double g) {
  return [g](ComplexValue mu) {
    const ComplexValue lines = 0.5 * mu * scaled_polylogarithm(g - 1.0, mu);
    const ComplexValue parabolas = scaled_polylogarithm(g - 2.0, mu) / (2.0 - g);
    return std::tgamma(2.0 - g) * std::pow(exp_minus_one(mu) / mu, g - 3.0) * std::exp(mu) /
           (parabolas - lines);
  };
}

// Piecewise quadratic interpolation of y: h^(3-g); powers as for L1, because the first step interpolates
// linearly.
const RateTheory l1_2_rates{[](double g) { return 3 - g; }, end_rate_of_interpolated_y,
                            first_step_rate_of_interpolated_y};

// (1-zeta)^g K with sigma = 1 - g/2: the weights of the increments have the generating function
//   C = (1-zeta)^2/(2 zeta) (Phi(zeta, g-2, sigma) / sigma - Phi(zeta, g-1, sigma)),
// and K = Gamma(2-g) / ((1-zeta) C).
double sigma_of(double g) { return 1.0 - 0.5 * g; }
Kernel kernel_of_l2_1_sigma(double g) {
  const double sigma = sigma_of(g);
  return [sigma, g, lines = Lerch(g - 1.0, sigma), parabolas = Lerch(g - 2.0, sigma)](ComplexValue mu) {
    return 2.0 * std::tgamma(2.0 - g) * std::exp(mu) * std::pow(exp_minus_one(mu) / mu, g - 3.0) /
           (parabolas.scaled(mu) / sigma + mu * lines.scaled(mu));
  };
}

// Exact at t* = t_(n-1) + sigma h for t^2 too, with y at t* from linear interpolation: h^2; t^2 has the error
// h^(2+g) at the first step, other powers are as for L1. f is evaluated at t*, inside the step.
const RateTheory l2_1_sigma_rates{
    [](double) { return 2.0; }, end_rate_of_interpolated_y,
    [](double g, double p) { return same_order(p, 2.0) ? 2 + g : first_step_rate_of_interpolated_y(g, p); },
    true};

// Solves with an interpolant of y by parabolas.
template <class Parabolas>
Trajectory solve_with(const Problem& problem, const Grid& grid, const Options& options) {
  Parabolas parabolas(problem, grid, options);
  return solve_with_interpolant(parabolas, problem, grid, options);
}

// A scheme for orders up to 1, and above 1 through y' = v, with an implicit symbol of these weights or this
// kernel, and further arguments of implicit_symbol.
template <class Weights, class... Offset>
Scheme split(Scheme scheme, const RateTheory& theory, GridSolve solve, const Weights& weights,
             const Offset&... offset_of) {
  scheme.expected_rate = expected_rate(theory, splitting_up_to_one);
  scheme.solve = with_split_orders(splitting_up_to_one, on_grid(std::move(solve)));
  scheme.symbol = [&weights, &offset_of...](const Problem& problem, double length) {
    return implicit_symbol(split_orders(problem, splitting_up_to_one(problem)), weights, length,
                           offset_of...);
  };
  return scheme;
}

}  // namespace

Scheme l1() {
  return split(
      {.id = "l1",
       .title = "L1",
       .source = "Oldham & Spanier 1974; Langlands & Henry, J. Comput. Phys. 205 (2005); orders above 1 "
                 "through y' = v",
       .capabilities = {.implicit = true, .algebraic_rows = true, .checkpoints = true}},
      l1_rates, solve_l1, families::l1);
}

// The Caputo derivative at t_n of the parabolas through y_(n-2), y_(n-1), y_n equals f(t_n, y_n), orders g in
// (0, 1]; g = 1 is BDF2 with a first step of backward Euler.
Scheme l1_2() {
  return split({.id = "l1_2",
                .title = "L1-2",
                .source = "Gao, Sun & Zhang, J. Comput. Phys. 259 (2014); orders above 1 through y' = v",
                .capabilities = {.implicit = true, .checkpoints = true}},
               l1_2_rates, solve_with<BackwardParabolas>, kernel_of_l1_2);
}

// The Caputo derivative at t_(n-1) + sigma h, sigma = 1 - g/2, of the parabolas through y_(n-1), y_n, y_(n+1)
// and a line on the newest step equals f there, orders g in (0, 1]. Each row is evaluated at the sigma of its
// order. g = 1 is the implicit midpoint rule.
Scheme l2_1_sigma() {
  return split({.id = "l2_1_sigma",
                .title = "L2-1-sigma",
                .source = "Alikhanov, J. Comput. Phys. 280 (2015); graded: Chen & Stynes, J. Sci. Comput. 79 "
                          "(2019); orders above 1 through y' = v",
                .capabilities = {.implicit = true, .checkpoints = true}},
               l2_1_sigma_rates, solve_with<ForwardParabolas>, kernel_of_l2_1_sigma, sigma_of);
}

}  // namespace fde
