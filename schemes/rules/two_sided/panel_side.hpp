// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "fdebench/schemes/rules/two_sided/panel_mesh.hpp"
#include "fdebench/schemes/rules/two_sided/side_rule.hpp"

namespace fde {

// The Gauss-Legendre points in (-1, 1), increasing, and the Legendre coefficients of the polynomial through
// values at them. The points are symmetric, as both sides use the same ones.
struct LegendrePoints {
  explicit LegendrePoints(Eigen::Index count);
  Vec points;
  Matrix to_coefficients;
};

// Collocation on panels: f is a polynomial on each, through its values at the Legendre points. The times are
// the start, the points of all panels, and the end, where values follow from the integrals.
//
// Given the rows of the other side, the rows of this side are solved panel by panel.
class PanelSide final : public SideRule {
 public:
  // The points must outlive it.
  PanelSide(const Problem& problem, Side side, const PanelMesh& mesh, const LegendrePoints& points);

  void integrate(const Rows& f, Rows& value) const override;
  [[nodiscard]] std::unique_ptr<SideFactors> factors(const Matrix& jacobians) const override;
  [[nodiscard]] std::size_t bytes() const override;

  // Adds to y the integrals of the rows of this side at a time on the given panel, in own order, that is
  // `since` panel lengths behind its start, from f at all times.
  void add_integrals(const Rows& f, Eigen::Index panel, double since, Out y) const;

 private:
  class Factors;

  // The integrals of an order at all later points, and at the end, from values at the points: one row a time,
  // one column a point.
  struct Integrals {
    double order;
    std::vector<Eigen::Index> rows;  // indices in rows_
    Matrix weights;
  };

  [[nodiscard]] Eigen::Index points() const { return points_.points.size(); }
  [[nodiscard]] Eigen::Index panels() const { return std::ssize(lengths_); }
  [[nodiscard]] Matrix weights(double order) const;
  // The rows of this side in own time, without the start.
  [[nodiscard]] Rows own(const Rows& all) const;
  [[nodiscard]] Eigen::Index column(Eigen::Index m) const { return right_ ? last_ - m : m; }

  std::vector<double> lengths_;  // in own order
  const LegendrePoints& points_;
  Eigen::Index last_;  // index of the end
  std::vector<Integrals> integrals_{};
};

// The times of panels, with the rules of both sides; with steps it is the product trapezoidal rule. The
// problem must outlive it.
std::shared_ptr<const Discretisation> discretisation_by_panels(const Problem& problem, const PanelMesh& mesh,
                                                               const LegendrePoints& points,
                                                               std::shared_ptr<const PanelSide> left,
                                                               std::shared_ptr<const PanelSide> right);

}  // namespace fde
