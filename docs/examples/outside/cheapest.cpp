#include <cstdio>
#include <string>

#include <fdebench/benchmarks/references/memoized_reference.hpp>
#include <fdebench/benchmarks/scenes/variant.hpp>
#include <fdebench/benchmarks/search/search.hpp>

// The cheapest runs of a relaxation whose error at the end is at most 1e-5, found in two seconds.
int main() {
  const fde::bench::Scene scene =
      fde::bench::make_scene(fde::bench::read_variant("relaxation", {"gamma=0.7"}));
  const fde::bench::AccuracyTarget target{
      {fde::Norm::end, fde::bench::Scale::mixed}, 1e-5, fde::bench::all_columns(scene)};
  const auto candidates = fde::bench::search(scene, target, 2.0, [](const std::string&, double) {});
  for (const fde::bench::SearchCandidate& candidate : candidates) {
    if (candidate.outcome != fde::bench::SearchOutcome::accuracy_reached) continue;
    std::printf("%s N = %d grading %g: error %.1e\n", std::string(candidate.configuration.scheme->id).c_str(),
                candidate.best.steps, candidate.configuration.grading, candidate.best.error().value);
  }
}
