// SPDX-License-Identifier: MIT
#include <cmath>

#include "fdebench/schemes/history/weights/polylogarithm.hpp"
#include "fdebench/schemes/rules/interpolants/parabolas.hpp"
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {
namespace {

// (1-zeta)^g K with sigma = 1 - g/2: the weights of the increments have the generating function
//   C = (1-zeta)^2/(2 zeta) (Phi(zeta, g-2, sigma) / sigma - Phi(zeta, g-1, sigma)),
// and K = Gamma(2-g) (sigma + (1-sigma) zeta) / ((1-zeta) C), because f is evaluated between y_(n-1) and y_n.
Kernel kernel_of(double g) {
  const double sigma = 1.0 - 0.5 * g;
  return [=, lines = Lerch(g - 1.0, sigma), parabolas = Lerch(g - 2.0, sigma)](ComplexValue mu) {
    const ComplexValue zeta = std::exp(mu);
    return 2.0 * std::tgamma(2.0 - g) * (sigma + (1.0 - sigma) * zeta) * zeta *
           std::pow(exp_minus_one(mu) / mu, g - 3.0) / (parabolas.scaled(mu) / sigma + mu * lines.scaled(mu));
  };
}

Trajectory solve_l2_1_sigma(const Problem& problem, const Grid& grid, const Options& options) {
  ForwardParabolas parabolas(problem, grid, options);
  return solve_with_interpolant(parabolas, problem, grid, options);
}

// Exact at t* = t_(n-1) + sigma h for t^2 too, with y at t* from linear interpolation: h^2; t^2 has the error
// h^(2+g) at the first step, other powers are as for L1. f is evaluated at t*, inside the step.
const RateTheory l2_1_sigma_rates{
    [](double) { return 2.0; }, end_rate_of_interpolated_y,
    [](double g, double p) { return same_order(p, 2.0) ? 2 + g : first_step_rate_of_interpolated_y(g, p); },
    true};

}  // namespace

// The Caputo derivative at t_(n-1) + sigma h, sigma = 1 - g/2, of the parabolas through y_(n-1), y_n, y_(n+1)
// and a line on the newest step equals f there, orders g in (0, 1]. Each row is evaluated at the sigma of its
// order. g = 1 is the implicit midpoint rule.
Scheme l2_1_sigma() {
  return {.id = "l2_1_sigma",
          .title = "L2-1-sigma",
          .source =
              "Alikhanov, J. Comput. Phys. 280 (2015); graded: Chen & Stynes, J. Sci. Comput. 79 (2019); "
              "orders above 1 through y' = v",
          .capabilities = {.implicit = true, .checkpoints = true},
          .expected_rate = expected_rate(l2_1_sigma_rates, splitting_up_to_one),
          .solve = with_split_orders(splitting_up_to_one, on_grid(solve_l2_1_sigma)),
          .symbol = [](const Problem& problem, double length) {
            return implicit_symbol(split_orders(problem, splitting_up_to_one(problem)), kernel_of, length);
          }};
}

}  // namespace fde
