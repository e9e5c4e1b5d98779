#include <cstdio>
#include <string>

#include <fdebench/benchmarks/measures/judge.hpp>
#include <fdebench/benchmarks/references/memoized_reference.hpp>
#include <fdebench/benchmarks/scenes/variant.hpp>
#include <fdebench/schemes/stepping/scheme.hpp>

// The pendulum of Yin, Liu & Anh up to t = 5 by the trapezoidal rule, judged by its reference.
int main() {
  const fde::bench::Scene pendulum =
      fde::bench::make_scene(fde::bench::read_variant("pendulum:alpha=1.9,until=5", {}));
  const fde::Grid grid{.end = pendulum.problem.end, .steps = 512};
  const auto path = fde::find_scheme("product_trapezoidal")->solve(pendulum.problem, grid, {});
  fde::bench::MemoizedReference reference(pendulum);
  const fde::bench::Assessment judged = fde::bench::judge(pendulum, path, reference, {.grid = grid});
  for (const fde::bench::MeasuredValue& measured : judged.measured)
    std::printf("%s %g %s\n", std::string(measured.id).c_str(), measured.value,
                std::string(measured.unit).c_str());
}
