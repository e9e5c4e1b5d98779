// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The panels of [0, end] by their lengths, whose sums from either side are the distances of their edges: next
// to an end they keep their relative accuracy. At singular edges, both ends and the breaking points of f, the
// solution behaves like a power of the distance.
struct PanelMesh {
  std::vector<double> lengths;
  std::vector<bool> singular;  // of the edges, one more than panels

  [[nodiscard]] std::size_t size() const { return lengths.size(); }
  [[nodiscard]] bool touches_singular_edge(std::size_t panel) const {
    return singular[panel] || singular[panel + 1];
  }
  // The distances of all edges from the start, and of those of the mirrored mesh.
  [[nodiscard]] Vec edges() const;
  [[nodiscard]] PanelMesh mirrored() const;
};

// Two panels between any two breaking points.
PanelMesh first_mesh(const Problem& problem);

// The mesh with a panel halved so many times: once in the middle, or towards its singular edge, where the
// lengths then fall by halves.
void divide(PanelMesh& mesh, std::size_t panel, int halvings);

}  // namespace fde
