#pragma once

#include <compare>
#include <map>
#include <vector>

#include "spectral/driven_rows.hpp"
#include "spectral/panel_rule.hpp"

namespace fde {

// Where a panel lies as seen from a later one, in widths of the later one: how wide it is, and the distance
// between them.
struct Lie {
  double width, gap;
  auto operator<=>(const Lie&) const = default;
};

// The fractional integrals of functions on panels, as matrices that act on Legendre coefficients; for a panel
// of width w they are in units of (w/2)^order. Those of how panels lie to each other are kept: on meshes
// whose widths are halves of each other a few occur again and again.
class PanelKernels {
 public:
  PanelKernels(const PanelRule& rule, const DrivenRows& driven);

  // Each order that occurs once, without 0; and which one a row has, -1 for order 0.
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }
  [[nodiscard]] Eigen::Index order_of(Eigen::Index row) const {
    return order_of_[static_cast<std::size_t>(row)];
  }

  // (w/2)^order, for every order.
  [[nodiscard]] Vec units(double width) const;

  // The integrals at the places of the panel itself, from values there.
  [[nodiscard]] const Matrix& own(Eigen::Index order) const { return own_[static_cast<std::size_t>(order)]; }

  // Those at the places of a later panel, one matrix an order. The reference lasts as long as this object.
  const std::vector<Matrix>& of(const Lie& lie);
  // The same without keeping it.
  [[nodiscard]] std::vector<Matrix> make(const Lie& lie) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  const PanelRule& rule_;
  std::vector<double> orders_;
  std::vector<Eigen::Index> order_of_;
  std::vector<Matrix> own_;
  std::map<Lie, std::vector<Matrix>> kept_;
};

}  // namespace fde
