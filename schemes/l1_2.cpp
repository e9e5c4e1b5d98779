// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/schemes/rules/interpolants/parabolas.hpp"
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {
namespace {

// (1-zeta)^g K: the weights of the increments have the generating function
//   C = (1-zeta)^2/zeta (Li_(g-1) / 2 + Li_(g-2) / (2-g)),
// and K = Gamma(2-g) / ((1-zeta) C).
Kernel kernel_of(double g) {
  return [g](ComplexValue mu) {
    const ComplexValue lines = 0.5 * mu * scaled_polylogarithm(g - 1.0, mu);
    const ComplexValue parabolas = scaled_polylogarithm(g - 2.0, mu) / (2.0 - g);
    return std::tgamma(2.0 - g) * std::pow(exp_minus_one(mu) / mu, g - 3.0) * std::exp(mu) /
           (parabolas - lines);
  };
}

Trajectory solve_l1_2(const Problem& problem, const Grid& grid, const Options& options) {
  BackwardParabolas parabolas(problem, grid, options);
  return solve_with_interpolant(parabolas, problem, grid, options);
}

// Piecewise quadratic interpolation of y: h^(3-g); powers as for L1, because the first step interpolates
// linearly.
const RateTheory l1_2_rates{[](double g) { return 3 - g; }, end_rate_of_interpolated_y,
                            first_step_rate_of_interpolated_y};

}  // namespace

// The Caputo derivative at t_n of the parabolas through y_(n-2), y_(n-1), y_n equals f(t_n, y_n), orders g in
// (0, 1]; g = 1 is BDF2 with a first step of backward Euler.
Scheme l1_2() {
  return {.id = "l1_2",
          .title = "L1-2",
          .source = "Gao, Sun & Zhang, J. Comput. Phys. 259 (2014); orders above 1 through y' = v",
          .capabilities = {.implicit = true, .checkpoints = true},
          .expected_rate = expected_rate(l1_2_rates, splitting_up_to_one),
          .solve = with_split_orders(splitting_up_to_one, on_grid(solve_l1_2)),
          .symbol = [](const Problem& problem, double length) {
            return implicit_symbol(split_orders(problem, splitting_up_to_one(problem)), kernel_of, length);
          }};
}

}  // namespace fde
