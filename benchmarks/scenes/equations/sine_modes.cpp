// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::bench {

namespace {

// sin(pi m / n), with the argument reduced exactly, in integers, to [0, pi/2].
double sine_of_part(long m, long n) {
  const long turned = m % (2 * n), rest = turned % n, angle = std::min(rest, n - rest);
  const double sine = std::sin(std::numbers::pi * static_cast<double>(angle) / static_cast<double>(n));
  return turned < n ? sine : -sine;
}

}  // namespace

double SineGrid::sine(int k, int j) const { return sine_of_part(static_cast<long>(k) * j, points + 1L); }

double SineGrid::rate(int k) const {
  const double sine = sine_of_part(k, 2 * (points + 1L));
  return 4.0 * intervals() * intervals() * sine * sine;
}

InitialField smooth_initial_field(const SineGrid& points, int modes) {
  InitialField start{Vec::Zero(modes), Vec::Zero(points.points)};
  for (int k = 1; k <= modes; ++k) {
    start.amplitudes[k - 1] = 1.0 / k;
    for (int j = 1; j <= points.points; ++j) start.values[j - 1] += points.sine(k, j) / k;
  }
  return start;
}

// The amplitudes are 2 dx sum_(j <= m) sin(j a) with a = k pi dx, m points below 1/2; the sum is sin(m a/2)
// sin((m+1) a/2) / sin(a/2).
InitialField step_initial_field(const SineGrid& points) {
  const int below = points.points / 2;
  const long halves = 2 * (points.points + 1L);
  InitialField start{Vec::Zero(points.points), Vec::Zero(points.points)};
  start.values.head(below).setOnes();
  for (long k = 1; k <= points.points; ++k) {
    const double sum =
        sine_of_part(k * below, halves) * sine_of_part(k * (below + 1), halves) / sine_of_part(k, halves);
    start.amplitudes[k - 1] = 2.0 / points.intervals() * sum;
  }
  return start;
}

SineGrid points_of(const Parameters& parameters, const char* name) {
  if (!is_integer_order(parameters[name])) reject(name, parameters[name], "a whole number");
  return {static_cast<int>(std::lround(parameters[name]))};
}

std::vector<Parameter> start_parameters() {
  return {choice("start", {"smooth", "step"}, "u(x, 0): sum sin(k pi x) / k, or 1 below x = 1/2 and 0 above"),
          {"modes", 3.0, {.low = 1.0, .high = 2000.0}, "of the smooth start, whole"}};
}

InitialField initial_field(const Parameters& parameters, const SineGrid& points, const char* points_name) {
  const double modes = parameters["modes"];
  if (!is_integer_order(modes)) reject("modes", modes, "a whole number");
  if (parameters.choice("start") == "step") return step_initial_field(points);
  if (modes > points.points)
    reject("modes", modes, fmt::format("at most {} = {}", points_name, points.points));
  return smooth_initial_field(points, static_cast<int>(std::lround(modes)));
}

// Rounding perturbs z = rate t^g by a few units, and E_g(-z) by as many units of z E_g'(-z) = z E_{g,g}(-z) /
// g; the factor 2 covers the second-order terms.
DecayFactor decay_factor(double order, double rate, double t) {
  const double z = rate * std::pow(t, order), of_time = t > 0.0 ? std::abs(std::log(t)) : 0.0;
  const auto left = reference::mittag_leffler(order, 1.0, std::complex<double>(-z));
  const double slope = z * reference::mittag_leffler(order, order, -z) / order;
  return {left.value.real(), left.bound + 2.0 * (8.0 + of_time) * rounding_unit * std::abs(slope)};
}

double steepest_decay(double order, double least_rate, double t) {
  const double power = std::pow(t, order);
  if (order > 1.0) return power / (order * std::tgamma(order));
  return power * reference::mittag_leffler(order, order, -least_rate * power) / order;
}

}  // namespace fde::bench
