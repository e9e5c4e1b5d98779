// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/reference_of.hpp"

#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/benchmarks/references/verified_reference.hpp"

namespace fde::bench {
namespace {

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
  const auto [problem, outputs] = reference_problem_of(scene);
  if (scene.name.empty()) return mapped_to_columns(outputs, computed_reference(problem));
  return mapped_to_columns(outputs, cached_reference(scene.name, problem, ReferenceCache(cache_folder())));
}

}  // namespace

PosedProblem reference_problem_of(const Scene& scene) {
  if (!scene.reference_problem) return {scene.problem, scene.outputs};
  PosedProblem posed = *scene.reference_problem;
  posed.problem.end = scene.problem.end;
  posed.problem.jump_times = scene.problem.jump_times;
  posed.problem.kink_times = scene.problem.kink_times;
  posed.problem.step_limits = scene.problem.step_limits;
  return posed;
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

}  // namespace fde::bench
