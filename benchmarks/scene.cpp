#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collocation.hpp"
#include "reference_cache.hpp"

namespace fde {

#define FDE_SCENE(id) SceneMaker id();
#include "scenes/list.def"
#undef FDE_SCENE

std::span<const SceneMaker> scenes() {
  static const std::vector<SceneMaker> all{
#define FDE_SCENE(id) id(),
#include "scenes/list.def"
#undef FDE_SCENE
  };
  return all;
}

const SceneMaker* scene_of_label(std::string_view label) {
  const auto found = std::ranges::find(scenes(), label.substr(0, label.find(':')), &SceneMaker::id);
  return found == scenes().end() ? nullptr : &*found;
}

Outputs picked(std::vector<std::string> names, std::vector<Eigen::Index> components) {
  return {std::move(names), [components = std::move(components)](double, In y, Out columns) {
            for (std::size_t c = 0; c < components.size(); ++c)
              columns[static_cast<Eigen::Index>(c)] = y[components[c]];
          }};
}

double Constraint::drift(double t, In columns) const {
  Vec f(size);
  value(t, columns, f);
  return f.lpNorm<Eigen::Infinity>();
}

Vec columns_at(const Outputs& outputs, double t, In y) {
  if (!outputs.of) return y;
  Vec columns(static_cast<Eigen::Index>(outputs.names.size()));
  outputs.of(t, y, columns);
  return columns;
}

std::vector<std::string> printed_names(const Scene& scene) {
  auto names = scene.outputs.names;
  if (scene.energy) names.emplace_back("energy");
  if (scene.constraint) names.emplace_back("constraint");
  return names;
}

Vec printed_values(const Scene& scene, double t, In columns) {
  Vec values(std::ssize(printed_names(scene)));
  values.head(columns.size()) = columns;
  Eigen::Index next = columns.size();
  if (scene.energy) values[next++] = scene.energy.value(columns);
  if (scene.constraint) values[next++] = scene.constraint.drift(t, columns);
  return values;
}

Rows columns_of(const Outputs& outputs, const Trajectory& path) {
  if (!outputs.of) return path.y;
  Rows columns(static_cast<Eigen::Index>(outputs.names.size()), path.y.cols());
  for (Eigen::Index c = 0; c < path.y.cols(); ++c) {
    outputs.of(path.grid.time(path.steps[static_cast<std::size_t>(c)]), path.y.col(c), columns.col(c));
  }
  return columns;
}

// The difference quotient of a column that is a component is exactly 1.
Vec bound_of_columns(const Outputs& outputs, double t, const Truth& truth, In columns) {
  Vec bound = Vec::Zero(columns.size()), shifted = truth.value;
  for (Eigen::Index i = 0; i < shifted.size(); ++i) {
    shifted[i] += 0x1p-26 * std::max(std::abs(shifted[i]), 1.0);
    const Vec quotient = (columns_at(outputs, t, shifted) - columns) / (shifted[i] - truth.value[i]);
    if (truth.bound[i] != 0.0) bound += quotient.cwiseAbs() * truth.bound[i];
    shifted[i] = truth.value[i];
  }
  return bound;
}

namespace {

Exact through(const Outputs& outputs, Exact components) {
  if (!outputs.of) return components;
  return {[outputs, components = std::move(components)](double t) -> Truth {
    const Truth truth = components.at(t);
    Vec columns = columns_at(outputs, t, truth.value);
    Vec bound = bound_of_columns(outputs, t, truth, columns);
    return {std::move(columns), std::move(bound)};
  }};
}

}  // namespace

PosedProblem posed_for_reference(const Scene& scene) {
  if (!scene.reference) return {scene.problem, scene.outputs};
  PosedProblem posed = *scene.reference;
  posed.problem.end = scene.problem.end;
  return posed;
}

Exact truth_of(const Scene& scene) {
  if (scene.exact.at) return scene.exact;
  if (!scene.no_reference.empty()) throw std::runtime_error(scene.no_reference);
  const auto [problem, outputs] = posed_for_reference(scene);
  if (scene.name.empty()) return through(outputs, reference_solution(problem));
  return through(outputs, cached_reference(scene.name, problem, ReferenceCache(cache_folder())));
}

}  // namespace fde
