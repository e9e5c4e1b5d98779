// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_solution.hpp"

#include <algorithm>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {

Vec PanelSolution::at(double t) const { return integrated_rows.origin + rows_at(t); }

Vec PanelSolution::rows_at(double t) const {
  const auto found = std::ranges::lower_bound(
      panels, t, {}, [](const MemoryBlock* panel) { return panel->block.time(1.0); });
  const MemoryBlock& panel = found == panels.end() ? *panels.back() : **found;
  if (panel.block.from == 0.0) return from_integrals(panel, t);
  const double place = panel.block.place(t);
  const Matrix weights = legendre_polynomials(Vec::Constant(1, place), rule.size()) * rule.to_coefficients;
  return (weights * panel.values).transpose();
}

Vec PanelSolution::from_integrals(const MemoryBlock& panel, double t) const {
  Vec rows = integrated_rows.taylor_part(t);
  for (const auto& tree : trees) {
    if (tree->block.segment->start < panel.block.segment->start) memory.add_at(*tree, t, rows);
  }
  memory.add_at(panel, t, rows);
  const double place = panel.block.place(t);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    if (memory.kernels().order_of(i) >= 0) continue;
    const auto drive = integrated_rows.rows[static_cast<std::size_t>(i)].unknown;
    rows[i] =
        legendre_polynomials(Vec::Constant(1, place), rule.size()).row(0).dot(panel.coefficients.col(drive));
  }
  return rows;
}

std::size_t PanelSolution::bytes() const {
  // A binary tree has one inner block less than panels.
  const auto numbers = 2 * integrated_rows.unknown_count() + integrated_rows.row_count();
  return memory.bytes() + sizeof(double) * panels.size() * static_cast<std::size_t>(rule.size() * numbers);
}

}  // namespace fde
