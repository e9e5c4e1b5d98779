#include <cmath>
#include <cstdio>

#include <fdebench/fdebench.hpp>

namespace bench = fde::bench;

// The cheapest run of a relaxation whose error at the end is at most 1e-5, what it gives there and what is
// right, and the errors of its scheme with other numbers of steps.
int main() {
  const auto variant = bench::read_variant("relaxation", {"gamma=0.7"});
  const bench::Scene scene = bench::make_scene(variant);
  const auto made =
      bench::choose(scene, {.error = 1e-5, .kind = {fde::Norm::end, bench::Scale::mixed}, .seconds = 2.0});
  const bench::RecommendedRun& best = made.options.front();
  const auto table = bench::solve(scene, {.scheme = best.schemes.front(), .settings = best.settings});
  const auto known = bench::exact(scene, {scene.problem.end});
  std::printf("%s with N = %d: %.8f, exactly %.8f\n", best.schemes.front().c_str(), best.steps,
              table.values(0, table.values.cols() - 1), known.values(0, 0));
  for (const bench::Record& run : bench::sweep({.scenes = {variant},
                                  .schemes = {fde::find_scheme("product_trapezoidal")},
                                  .resolutions = {64, 128, 256}}))
    std::printf("N = %d: error %.1e\n", run.steps, run["error_end"].value_or(NAN));
}
