#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fdebench/reference/nonlinear/collocation.hpp>
#include <fdebench/schemes/stepping/scheme.hpp>

// D^order y = 1 - y^2, y(0) = 0; of order 1 this is tanh.
int main(int count, char** arguments) {
  const double order = count > 1 ? std::atof(arguments[1]) : 0.9;
  const fde::Problem riccati{.components = {{.order = order, .initial = {0.0}}},
                             .rhs = [](double, fde::In y, fde::Out f) { f[0] = 1.0 - y[0] * y[0]; },
                             .end = 1.0};
  const fde::reference::Reference exact = fde::reference::reference_solution(riccati);
  const auto [value, bound] = exact.at(1.0);
  std::printf("y(1) = %.15f, known to %.0e\n", value[0], bound[0]);
  for (const fde::Scheme& scheme : fde::schemes()) {
    const fde::Grid grid{.end = riccati.end, .steps = 1024};
    if (fde::unsupported_reason(scheme, riccati, grid)) continue;
    const fde::Trajectory path = scheme.solve(riccati, grid, {.output_times = {1.0}});
    if (path.status != fde::SolveStatus::finished) return 3;
    std::printf("%-24s %.1e\n", std::string(scheme.id).c_str(), std::abs(path.y(0, 0) - value[0]));
  }
}
