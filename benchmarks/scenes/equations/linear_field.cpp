// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/linear_field.hpp"

namespace fde::bench {

std::vector<Component> field_components(const FieldShape& shape, const Vec& start, double order) {
  std::vector<Component> all;
  all.reserve(static_cast<std::size_t>(shape.size()));
  const auto add = [&](double value) {
    all.push_back({order, order > 1.0 ? std::vector{value, 0.0} : std::vector{value}});
  };
  for (const double y : shape.dimensions == 1 ? Vec::Ones(1) : start) {
    for (const double x : start) add(x * y);
  }
  return all;
}

Scene scene_of_field(const std::shared_ptr<const LinearField>& field, double order) {
  Scene scene;
  scene.problem.components = field_components(field->shape(), field->initial_values_on_axis(), order);
  scene.problem.rhs = [field](double, In u, Out f) { field->apply(u, f); };
  scene.problem.derivatives = SparseLinearPart{field->matrix()};
  scene.smoothness.powers.assign(scene.problem.components.size(),
                                 power_lattice({order}, {order}, order + 2.0));
  scene.outputs = field->outputs();
  if (field->has_exact_solution()) {
    scene.reference = {.at = [field](double t) { return field->exact_columns_at(t); },
                       .evidence = reference::Evidence::closed_form};
  }
  return scene;
}

}  // namespace fde::bench
