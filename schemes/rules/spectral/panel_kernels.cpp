// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_kernels.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {

PanelKernels::PanelKernels(const PanelRule& rule, const IntegratedRows& integrated_rows) : rule_(rule) {
  for (const auto& row : integrated_rows.rows) {
    if (row.order == 0.0) {
      order_of_.push_back(-1);
      continue;
    }
    const auto found = std::ranges::find(orders_, row.order);
    order_of_.push_back(found - orders_.begin());
    if (found == orders_.end()) orders_.push_back(row.order);
  }
  const Vec beyond = rule.points.array() - 1.0;
  for (const double order : orders_)
    own_integrals_.emplace_back(kernel_moments(order, beyond, rule.size()) * rule.to_coefficients);
}

Vec PanelKernels::units(double width) const {
  Vec units(std::ssize(orders_));
  for (Eigen::Index g = 0; g < units.size(); ++g)
    units[g] = std::pow(width / 2.0, orders_[static_cast<std::size_t>(g)]);
  return units;
}

const std::vector<Matrix>& PanelKernels::integrals_on(const RelativePosition& position) {
  auto found = cache_.find(position);
  if (found == cache_.end()) found = cache_.emplace(position, compute_integrals(position)).first;
  return found->second;
}

std::vector<Matrix> PanelKernels::compute_integrals(const RelativePosition& position) const {
  const Vec beyond = (2.0 * position.gap + 1.0 + rule_.points.array()) / position.width;
  std::vector<Matrix> kernels;
  for (const double order : orders_) kernels.push_back(kernel_moments(order, beyond, rule_.size()));
  return kernels;
}

std::size_t PanelKernels::bytes() const {
  return sizeof(double) * (cache_.size() + 1) * orders_.size() *
         static_cast<std::size_t>(rule_.size() * rule_.size());
}

}  // namespace fde
