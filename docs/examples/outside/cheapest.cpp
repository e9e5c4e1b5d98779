#include <cstdio>
#include <string>

#include <fdebench/benchmarks/scenes/variant.hpp>
#include <fdebench/benchmarks/search/search.hpp>

// The cheapest runs of a relaxation whose error at the end is at most 1e-5, found in two seconds.
int main() {
  const fde::Scene scene = fde::make_scene(fde::read_variant("relaxation", {"gamma=0.7"}));
  const fde::AccuracyTarget question{{fde::Norm::end, fde::Scale::mixed}, 1e-5, fde::all_columns(scene)};
  const auto ways = fde::search(scene, question, 2.0, [](const std::string&, double) {});
  for (const fde::SearchCandidate& way : ways) {
    if (way.found != fde::Found::within) continue;
    std::printf("%s N = %d grading %g: error %.1e\n", std::string(way.way.scheme->id).c_str(), way.best.steps,
                way.way.grading, way.best.error);
  }
}
