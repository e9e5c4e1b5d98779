// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/region_boundary.hpp"

#include <numbers>

#include "fdebench/schemes/diagnostics/boundary_normal.hpp"

namespace fde {
namespace {

constexpr int halvings = 8;  // of the interval in which a piece ends

// The angle theta for f in [0, 1], from 1e-6 to pi, with points denser at both ends.
double angle_at(double f) { return std::numbers::pi * f * f * f * (4.0 - 3.0 * f) + 1e-6 * (1.0 - f); }

// One root locus curve, from the root `last` at zeta = -1 to zeta = 1.
class BoundaryCurve {
 public:
  BoundaryCurve(const Scheme& scheme, double order, int points, ComplexValue last)
      : scheme_(scheme), order_(order) {
    ComplexValue z = last;
    for (int i = points; i >= 0; --i) {
      const double theta = angle_at(static_cast<double>(i) / points);
      z = nearest_root(root_locus(scheme, order, theta), z);
      curve_.push_back({theta, z});
    }
  }

  void add_pieces(std::vector<std::vector<BoundaryPoint>>& pieces) const {
    bool inside = false;
    for (std::size_t i = 0; i < curve_.size(); ++i) {
      const bool divided = divides(curve_[i]);
      if (divided && !inside) pieces.emplace_back();
      if (divided != inside && i > 0) {
        const auto end =
            divided ? end_of_piece(curve_[i], curve_[i - 1]) : end_of_piece(curve_[i - 1], curve_[i]);
        pieces.back().push_back(end);
      }
      if (divided) pieces.back().push_back(curve_[i]);
      inside = divided;
    }
  }

 private:
  // Whether stability changes across the curve at this point. For an implicit rule the whole curve is
  // boundary.
  [[nodiscard]] bool divides(const BoundaryPoint& at) const {
    if (scheme_.capabilities.implicit) return true;
    const ComplexValue out = boundary_normal(scheme_, order_, at.theta, at.z, 1e-3);
    return is_stable(at.z + out) != is_stable(at.z - out);
  }
  [[nodiscard]] bool is_stable(ComplexValue z) const {
    return is_linearly_stable(scheme_, test_problem(scheme_, order_, z), 1.0);
  }

  // The end of a piece by bisection, between a point of the piece and a point that is not on it.
  [[nodiscard]] BoundaryPoint end_of_piece(BoundaryPoint of_it, const BoundaryPoint& beyond) const {
    double outside = beyond.theta;
    for (int halving = 0; halving < halvings; ++halving) {
      const double theta = 0.5 * (of_it.theta + outside);
      const BoundaryPoint middle{theta, nearest_root(root_locus(scheme_, order_, theta), of_it.z)};
      if (divides(middle)) {
        of_it = middle;
      } else {
        outside = theta;
      }
    }
    return of_it;
  }

  const Scheme& scheme_;
  double order_;
  std::vector<BoundaryPoint> curve_{};
};

}  // namespace

std::vector<std::vector<BoundaryPoint>> region_boundary(const Scheme& scheme, double order, int points) {
  std::vector<std::vector<BoundaryPoint>> pieces;
  for (const ComplexValue last : root_locus(scheme, order, std::numbers::pi))
    BoundaryCurve(scheme, order, points, last).add_pieces(pieces);
  return pieces;
}

}  // namespace fde
