// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/reference_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

namespace {

// The problem with the end of the scene.
PosedProblem on_interval_of(const Scene& scene, PosedProblem posed) {
  posed.problem.end = scene.problem.end;
  posed.problem.jump_times = scene.problem.jump_times;
  posed.problem.kink_times = scene.problem.kink_times;
  posed.problem.step_limits = scene.problem.step_limits;
  return posed;
}

reference::Reference mapped_to_columns(const Outputs& outputs, reference::Reference components) {
  if (!outputs.evaluate) return components;
  const auto evidence = components.evidence;
  const auto seconds = components.seconds;
  return {.at = [outputs, components = std::move(components)](double t) -> reference::ReferenceValue {
            const reference::ReferenceValue known = components.at(t);
            Vec columns = columns_at(outputs, t, known.value);
            Vec bound = propagated_bound(outputs, t, known, columns);
            return {std::move(columns), std::move(bound)};
          },
          .evidence = evidence,
          .seconds = seconds};
}

reference::Reference found_reference(const Scene& scene) {
  if (scene.reference.at) return scene.reference;
  const auto computed = [&](const PosedProblem& posed) {
    return mapped_to_columns(
        posed.outputs, scene.name.empty()
                           ? computed_reference(posed.problem)
                           : cached_reference(scene.name, posed.problem, ReferenceCache(cache_folder())));
  };
  auto reference = computed(reference_problem_of(scene));
  if (!scene.comparison_problem) return reference;
  return reference::with_difference(computed(on_interval_of(scene, *scene.comparison_problem)),
                                    std::move(reference));
}

constexpr std::array<std::string_view, 2> judges{"radau_exponentials", "spectral_collocation"};

// The columns at these times, one row a column, computed by this scheme; nullopt if it cannot.
std::optional<Rows> coarse_run(std::string_view id, const PosedProblem& posed,
                               const std::vector<double>& times, double size) {
  constexpr double tolerance = 1e-5, seconds = 2.0;
  const Scheme& scheme = *find_scheme(id);
  const Tolerance requested{tolerance, tolerance * size};
  if (unsupported_reason(scheme, posed.problem, requested)) return std::nullopt;
  const Trajectory path = scheme.solve(posed.problem, requested, {.budget = seconds, .output_times = times});
  if (path.status != SolveStatus::finished || path.times != times) return std::nullopt;
  return columns_of(posed.outputs, path);
}

}  // namespace

PosedProblem reference_problem_of(const Scene& scene) {
  if (!scene.reference_problem) return {scene.problem, scene.outputs};
  return on_interval_of(scene, *scene.reference_problem);
}

reference::Reference reference_of(const Scene& scene) {
  reference::Reference reference = found_reference(scene);
  // A reference by two methods has been examined by its residual.
  if (scene.from_file && scene.reference.at) require_agreement(scene, reference);
  return reference;
}

bool is_examined_at_points_only(const Scene& scene) {
  return !scene.reference.at && !reference_problem_of(scene).problem.range;
}

std::string_view evidence_of(const Scene& scene) {
  const auto evidence = scene.reference.at ? scene.reference.evidence : reference::Evidence::two_methods;
  switch (evidence) {
    case reference::Evidence::closed_form:
      return "closed form";
    case reference::Evidence::laplace_transform:
      return "inverse Laplace transform";
    case reference::Evidence::two_methods:
      return is_examined_at_points_only(scene) ? "two methods, examined at points only" : "two methods";
    case reference::Evidence::estimate:
      break;
  }
  return "estimate";
}

void require_agreement(const Scene& scene, const reference::Reference& reference) {
  const auto posed = scene.ill_posed_reason.empty() ? PosedProblem{scene.problem, scene.outputs}
                                                    : reference_problem_of(scene);
  constexpr double agree = 1e-3, differ = 1e-2;
  const double end = posed.problem.end;
  const std::vector<double> times{end / 7.0, end / 2.0, end};
  Rows known(std::ssize(posed.outputs.names), std::ssize(times)), bound = known;
  for (Eigen::Index c = 0; c < known.cols(); ++c) {
    const reference::ReferenceValue value = reference.at(times[static_cast<std::size_t>(c)]);
    known.col(c) = value.value;
    bound.col(c) = value.bound;
  }
  if (!known.allFinite()) return;
  const double largest = known.cwiseAbs().maxCoeff(), size = largest == 0.0 ? 1.0 : largest;
  std::array<Rows, judges.size()> runs;
  for (std::size_t s = 0; s < judges.size(); ++s) {
    auto run = coarse_run(judges[s], posed, times, size);
    if (!run || !run->allFinite()) return;
    runs[s] = std::move(*run);
  }
  const auto& [one, other] = runs;
  for (Eigen::Index i = 0; i < known.rows(); ++i) {
    const double scale = std::max(known.row(i).cwiseAbs().maxCoeff(), one.row(i).cwiseAbs().maxCoeff());
    for (Eigen::Index c = 0; c < known.cols(); ++c) {
      if (std::abs(one(i, c) - other(i, c)) > agree * scale) continue;
      if (std::abs(known(i, c) - one(i, c)) <= differ * scale + bound(i, c)) continue;
      throw std::runtime_error(fmt::format(
          "what is known of {} at t = {:.6g} is not believed: it says {:.10g}, {} says {:.6g} and {} {:.6g}",
          posed.outputs.names[static_cast<std::size_t>(i)], times[static_cast<std::size_t>(c)], known(i, c),
          judges[0], one(i, c), judges[1], other(i, c)));
    }
  }
}

}  // namespace fde::bench
