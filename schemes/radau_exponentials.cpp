#include "adaptive/adaptive_march.hpp"
#include "adaptive/radau_steps.hpp"
#include "stepping/splitting.hpp"

namespace fde {
namespace {

Trajectory solve_adaptively(const Problem& problem, const Resolution& resolution, const Options& options) {
  const auto accuracy = std::get<Accuracy>(resolution);
  return march_adaptively(problem, accuracy, options, [&](Run& run, double shortest) {
    return std::make_unique<RadauSteps>(problem, accuracy, options, run, shortest);
  });
}

}  // namespace

// Orders above 1 are split, because RadauSteps is for orders up to 1.
Scheme radau_exponentials() {
  return {.id = "radau_exponentials",
          .title = "Radau IIA with exponentials",
          .source =
              "Hairer & Wanner, Solving Ordinary Differential Equations II (1996), section IV.8; memory as "
              "Guglielmi & Hairer, arXiv 2506.04188 (2025)",
          .needs = {.takes_grid = false,
                    .takes_accuracy = true,
                    .implicit = true,
                    .algebraic_rows = true,
                    .checkpoints = true},
          .solve = split_into(links_up_to_one, solve_adaptively)};
}

}  // namespace fde
