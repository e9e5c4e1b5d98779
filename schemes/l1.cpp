// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
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

}  // namespace

Scheme l1() {
  return {.id = "l1",
          .title = "L1",
          .source =
              "Oldham & Spanier 1974; Langlands & Henry, J. Comput. Phys. 205 (2005); orders above 1 through "
              "y' = v",
          .capabilities = {.implicit = true, .algebraic_rows = true, .checkpoints = true},
          .expected_rate = expected_rate(l1_rates, splitting_up_to_one),
          .solve = with_split_orders(splitting_up_to_one, on_grid(solve_l1)),
          .symbol = [](const Problem& problem, double length) {
            return implicit_symbol(split_orders(problem, splitting_up_to_one(problem)), families::l1, length);
          }};
}

}  // namespace fde
