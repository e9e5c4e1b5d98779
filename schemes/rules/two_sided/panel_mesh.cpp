// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/panel_mesh.hpp"

#include <algorithm>

namespace fde {

Vec PanelMesh::edges() const {
  Vec all = Vec::Zero(std::ssize(lengths) + 1);
  for (Eigen::Index k = 0; k + 1 < all.size(); ++k)
    all[k + 1] = all[k] + lengths[static_cast<std::size_t>(k)];
  return all;
}

PanelMesh PanelMesh::mirrored() const {
  return {{lengths.rbegin(), lengths.rend()}, {singular.rbegin(), singular.rend()}};
}

PanelMesh first_mesh(const Problem& problem) {
  PanelMesh mesh{{}, {true}};
  double last = 0.0;
  const auto add_until = [&](double t) {
    const double half = (t - last) / 2.0;
    mesh.lengths.insert(mesh.lengths.end(), {half, half});
    mesh.singular.insert(mesh.singular.end(), {false, true});
    last = t;
  };
  for (const double t : breaking_points(problem)) {
    if (t > last && t < problem.end) add_until(t);
  }
  add_until(problem.end);
  return mesh;
}

void divide(PanelMesh& mesh, std::size_t panel, int halvings) {
  const bool left = mesh.singular[panel], right = mesh.singular[panel + 1];
  if (left == right) halvings = 1;
  std::vector<double> parts;
  double length = mesh.lengths[panel];
  for (int k = 0; k < halvings; ++k) parts.push_back(length /= 2.0);
  parts.push_back(length);
  if (!right) std::ranges::reverse(parts);
  const auto at = static_cast<std::ptrdiff_t>(panel);
  mesh.lengths.erase(mesh.lengths.begin() + at);
  mesh.lengths.insert(mesh.lengths.begin() + at, parts.begin(), parts.end());
  mesh.singular.insert(mesh.singular.begin() + at + 1, parts.size() - 1, false);
}

}  // namespace fde
