// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// n points x_j = j / (n + 1) inside (0, 1). The vectors sin(k pi x_j), k = 1 ... n, are the eigenvectors of
// second differences with 0 at both ends; the eigenvalues are -rate(k).
struct SineGrid {
  int points;

  [[nodiscard]] double intervals() const { return points + 1.0; }
  // sin(k pi x_j), accurate to rounding for any k.
  [[nodiscard]] double sine(int k, int j) const;
  // 4 / dx^2 sin^2(k pi dx / 2).
  [[nodiscard]] double rate(int k) const;
};

// A field at t = 0 along an axis: amplitudes[k - 1] of sin(k pi x), and the values at the points.
struct InitialField {
  Vec amplitudes, values;
};

// sum_(k <= modes) sin(k pi x) / k.
InitialField smooth_initial_field(const SineGrid& points, int modes);
// 1 at the points below 1/2, and 0 at the others.
InitialField step_initial_field(const SineGrid& points);

// The grid whose number of points this parameter gives. Throws std::invalid_argument if it is not an integer.
SineGrid points_of(const Parameters& parameters, const char* name);

// The parameters `start` and `modes` of the diffusion scenes, and the initial field that they give.
std::vector<Parameter> start_parameters();
InitialField initial_field(const Parameters& parameters, const SineGrid& points, const char* points_name);

inline constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

// The factor by which a mode has decayed, with an error bound.
struct DecayFactor {
  double value, bound;
};

// The solution at t of D^order u = -rate u, u(0) = 1, u'(0) = 0: E_order(-rate t^order), 0 < order <= 2.
DecayFactor decay_factor(double order, double rate, double t);

// A bound of |d decay / d rate| for all rates >= least_rate: the largest |t^g E_{g,g}(-rate t^g)| / g. Up to
// order 1, E_{g,g} decreases; above, |E_{g,g}| is below 1 / Gamma(g).
double steepest_decay(double order, double least_rate, double t);

}  // namespace fde::bench
