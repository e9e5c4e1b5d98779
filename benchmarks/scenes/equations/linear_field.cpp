// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/linear_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fde::bench {

namespace {

constexpr int longest_shown = 2000, shown_of_a_line = 9, shown_of_a_side = 3;

// The points that are columns: names and components.
struct OutputPoints {
  std::vector<std::string> names{};
  std::vector<Eigen::Index> components{};
};

OutputPoints output_points_of(const FieldShape& shape) {
  OutputPoints places;
  const auto show = [&](std::string name, Eigen::Index component) {
    places.names.push_back(std::move(name));
    places.components.push_back(component);
  };
  const auto shown = output_points(shape);
  for (const int i : shown) {
    if (shape.dimensions == 1) {
      show(fmt::format("u{}", i), i - 1);
      continue;
    }
    for (const int j : shown)
      show(fmt::format("u{}_{}", i, j), i - 1 + static_cast<Eigen::Index>(shape.points) * (j - 1));
  }
  return places;
}

}  // namespace

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

Eigen::Index FieldShape::size() const {
  const Eigen::Index n = points;
  return dimensions == 1 ? n : n * n;
}

bool outputs_all_points(const FieldShape& shape) {
  return shape.dimensions == 1 && shape.points <= longest_shown;
}

std::vector<int> output_points(const FieldShape& shape) {
  const int points = shape.points;
  const int most = outputs_all_points(shape) ? points
                   : shape.dimensions == 1   ? shown_of_a_line
                                             : shown_of_a_side;
  std::vector<int> some;
  for (int i = 1; i <= std::min(most, points); ++i) {
    const double place = points <= most ? i : i * (points + 1.0) / (most + 1);
    some.push_back(static_cast<int>(std::lround(place)));
  }
  return some;
}

SparseMatrix five_point_matrix(const FieldShape& shape, const Vec& x_coupling, const Vec& y_coupling,
                               const std::function<double(Eigen::Index place)>& diagonal) {
  const Eigen::Index n = shape.points, size = shape.size();
  SparseMatrix result(size, size);
  result.reserve(Eigen::VectorXi::Constant(static_cast<int>(size), 2 * shape.dimensions + 1));
  for (Eigen::Index place = 0; place < size; ++place) {
    const Eigen::Index i = place % n;
    if (place >= n) result.insert(place - n, place) = y_coupling[i];
    if (i > 0) result.insert(place - 1, place) = x_coupling[i];
    result.insert(place, place) = diagonal(place);
    if (i + 1 < n) result.insert(place + 1, place) = x_coupling[i + 1];
    if (place + n < size) result.insert(place + n, place) = y_coupling[i];
  }
  result.makeCompressed();
  return result;
}

Outputs field_outputs(const FieldShape& shape, double intervals, bool with_maximum) {
  auto [names, components] = output_points_of(shape);
  if (outputs_all_points(shape)) return {.names = std::move(names)};
  names.emplace_back("l2");
  if (with_maximum) names.emplace_back("max");
  const double root_of_cell = std::sqrt(std::pow(intervals, -shape.dimensions));
  const auto of = [components = std::move(components), root_of_cell, with_maximum](double, In u,
                                                                                   Out columns) {
    const Eigen::Index points = std::ssize(components);
    columns.head(points) = u(components);
    // Of a copy, as the alignment of u would change the order of the sum; u^2 may overflow.
    columns[points] = root_of_cell * Vec(u).stableNorm();
    if (with_maximum) columns[points + 1] = u.lpNorm<Eigen::Infinity>();
  };
  return {.names = std::move(names), .evaluate = of};
}

}  // namespace fde::bench
