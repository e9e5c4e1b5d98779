// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation/panel_noise.hpp"

#include <limits>

#include "fdebench/reference/nonlinear/march/implicit_step.hpp"

namespace fde::reference {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr double some_roundings = roundings_of_forcing * rounding;
constexpr double noises = 4.0;  // the sum of some rounding errors

}  // namespace

PanelNoise::PanelNoise(const Problem& problem, const PanelBasis& basis, double tolerance)
    : problem_(problem), basis_(basis), tolerance_(tolerance), rhs_noise_(problem) {}

Vec PanelNoise::negligible_rhs(const Solution& panel) const {
  return tolerance_ * panel.sizes.rhs + some_roundings * panel.sizes.forcing + noises * panel.noise.rhs +
         panel.left_unresolved.rhs;
}

Vec PanelNoise::negligible_values(const Solution& panel) const {
  return tolerance_ * panel.sizes.values + some_roundings * panel.increment + noises * panel.noise.values +
         panel.left_unresolved.values;
}

bool PanelNoise::detect(const Solution& panel, double from, double to, double scale) {
  constexpr Eigen::Index tail = 4;
  const Matrix coefficients = basis_.legendre * panel.rhs;
  const Vec unresolved = coefficients.bottomRows(tail).cwiseAbs().colwise().maxCoeff();
  return rhs_noise_.detect(from + (to - from) * basis_.nodes.array(), panel.values.topRows(basis_.points()),
                           unresolved, negligible_rhs(panel), scale);
}

bool PanelNoise::detect(const Panel& last, const MagnitudeScales& sizes) {
  const Vec negligible = some_roundings * (sizes.rhs + sizes.forcing);
  const Vec unresolved = negligible.cwiseMax(std::numeric_limits<double>::min());
  return rhs_noise_.detect(last.from + last.length() * basis_.dense_nodes.array(), last.values, unresolved,
                           negligible, sizes.largest());
}

Vec PanelNoise::record_panel(const Solution& panel, double from, double to, const Matrix& values) {
  panels_.push_back({from, to, panel.sizes.noise, panel.noise.values});
  const Vec explained = noises * rounding * (panel.sizes.rhs + panel.sizes.forcing);
  rhs_noise_.update_after_step(from + (to - from) * basis_.dense_nodes.array(), values, explained);
  return panel.sizes.values + panel.increment + (largest_of_values(to) + integrated(to)) / rounding;
}

// The noise of y on the panels since a tenth of the time. Multipliers, and what they drive, have noise on the
// first panels that grows as these get shorter; later their integrals remain, which are noise of the present
// size.
Vec PanelNoise::largest_of_values(double to) const {
  constexpr double window = 10.0;
  Vec largest = panels_.back().values_noise;
  for (std::size_t k = panels_.size(); k-- > 0 && window * panels_[k].to >= to;)
    largest = largest.cwiseMax(panels_[k].values_noise);
  return largest;
}

// An upper bound of the contribution of the noise of f to y, as if the noise had the same sign throughout.
Vec PanelNoise::integrated(double to) const {
  const auto added_since = [&](double time, const Vec& rhs_noise) -> Vec {
    return unit_increment(problem_, to - time).cwiseProduct(rhs_noise);
  };
  Vec sum = added_since(panels_.back().from, panels_.back().rhs_noise);
  for (std::size_t k = 0; k + 1 < panels_.size(); ++k) {
    const auto& [start, end, noise, of_values] = panels_[k];
    if (!noise.isZero(0.0)) {
      sum += (added_since(start, noise) - added_since(end, noise)).cwiseMax(0.0);
    }
  }
  return sum;
}

}  // namespace fde::reference
