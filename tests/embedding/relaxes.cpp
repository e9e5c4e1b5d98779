// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include <fdebench/schemes/stepping/scheme.hpp>

// D^0.5 y = -y, y(0) = 1, whose solution is E_0.5(-sqrt(t)) = e^t erfc(sqrt(t)).
int main() {
  const fde::Problem problem{.components = {{.order = 0.5, .initial = {1.0}}},
                             .rhs = [](double, fde::In y, fde::Out f) { f = -y; },
                             .end = 1.0};
  const auto* scheme = fde::find_scheme("product_trapezoidal");
  // Times (n / 4096)^2: fine where y changes like sqrt(t).
  const fde::Grid grid{.end = 1.0, .steps = 4096, .grading = 2.0};
  const auto path = scheme->solve(problem, grid, {.output_times = {1.0}});
  if (path.status != fde::SolveStatus::finished) return 3;
  const double y = path.y(0, 0), error = std::abs(y - std::exp(1.0) * std::erfc(1.0));
  std::printf("y(1) = %.12f, error %.1e\n", y, error);
  return error < 1e-7 ? 0 : 1;
}
