#pragma once

#include <string>

#include "scenes/scene.hpp"

namespace fde {

// n points x_j = j / (n + 1) inside (0, 1), with the vectors sin(k pi x_j), k = 1 ... n, which second
// differences with 0 at both ends multiply by -rate(k).
struct SinePoints {
  int points;

  [[nodiscard]] double intervals() const { return points + 1.0; }
  // sin(k pi x_j), to rounding for any k.
  [[nodiscard]] double sine(int k, int j) const;
  // 4 / dx^2 sin^2(k pi dx / 2).
  [[nodiscard]] double rate(int k) const;
};

// What a field is at t = 0: amplitudes[k - 1] of sin(k pi x), and its values at the points.
struct SineStart {
  Vec amplitudes, values;
};

// sum_(k <= modes) sin(k pi x) / k.
SineStart smooth_start(const SinePoints& points, int modes);
// 1 at the points below 1/2, and 0 at the others.
SineStart step_start(const SinePoints& points);

// The points that this parameter counts. Throws std::invalid_argument where it is not whole.
SinePoints points_of(const Parameters& parameters, const char* name);

// What both scenes of diffusion ask about the start: `start` and `modes`, and the start that these say.
std::vector<Parameter> start_parameters();
SineStart start_of(const Parameters& parameters, const SinePoints& points, const char* points_name);

}  // namespace fde
