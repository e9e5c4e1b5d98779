// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/rule_rates.hpp"

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

const RateTheory trapezoidal_theory{[](double) { return 2.0; }, end_rate_of_interpolated_f,
                                    first_step_rate_of_interpolated_f};

// Backward Euler is exact for t.
const RateTheory grunwald_letnikov_theory{[](double) { return 1.0; },
                                          [](double, double) { return exact_power; },
                                          [](double g, double p) {
                                            if (g == 1.0 && same_order(p, 1.0)) return exact_power;
                                            return p;
                                          }};

}  // namespace fde
