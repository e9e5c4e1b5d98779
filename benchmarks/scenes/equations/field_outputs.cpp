// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/field_outputs.hpp"

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
    columns[points] = root_of_cell * u.stableNorm();  // stableNorm: u^2 may overflow
    if (with_maximum) columns[points + 1] = u.lpNorm<Eigen::Infinity>();
  };
  return {.names = std::move(names), .evaluate = of};
}

}  // namespace fde::bench
