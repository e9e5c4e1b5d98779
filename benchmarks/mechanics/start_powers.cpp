#include "start_powers.hpp"

#include <algorithm>

namespace fde::mechanics {
namespace {

constexpr double last = 3.0;  // later powers change no rate

std::vector<double> shifted(std::vector<double> powers, double by) {
  for (double& power : powers) power += by;
  return powers;
}

std::vector<double> without(std::vector<double> powers, double power) {
  std::erase_if(powers, [=](double p) { return same_order(p, power); });
  return powers;
}

std::vector<double> with_zero(std::vector<double> powers) {
  powers.insert(powers.begin(), 0.0);
  return powers;
}

// z' is made of what v and q are made of.
MotionPowers motion_powers(const std::vector<double>& leaving, bool moving) {
  const auto all = with_zero(leaving);
  return {moving ? all : leaving, shifted(all, 1.0)};
}

void add(Smoothness& smoothness, Eigen::Index times, const std::vector<double>& powers) {
  smoothness.powers.insert(smoothness.powers.end(), static_cast<std::size_t>(times), powers);
}

}  // namespace

MotionPowers powers_below_one(double order, bool moving, bool singular) {
  const std::vector<double> start = singular ? std::vector{1.0 - order, 1.0} : std::vector{1.0};
  return motion_powers(power_lattice(start, {1.0, 1.0 - order}, last), moving);
}

MotionPowers powers_above_one(double order, bool moving) {
  return motion_powers(power_lattice({1.0}, {1.0, order - 1.0}, last), moving);
}

Smoothness integrated_start(const MotionPowers& powers, double order, Eigen::Index coordinates) {
  Smoothness smoothness;
  add(smoothness, coordinates, shifted(powers.velocity, 1.0));
  add(smoothness, coordinates, powers.free_part);
  add(smoothness, coordinates, shifted(powers.velocity, 1.0 - order));
  return smoothness;
}

Smoothness acceleration_start(const MotionPowers& powers, double order, Eigen::Index coordinates,
                              bool singular) {
  const auto leaving = without(powers.velocity, 0.0);
  Smoothness smoothness;
  add(smoothness, coordinates, shifted(powers.velocity, 1.0));
  add(smoothness, coordinates, leaving);
  add(smoothness, coordinates, shifted(singular ? without(leaving, 1.0 - order) : leaving, -order));
  add(smoothness, coordinates, shifted(powers.velocity, 1.0 - order));
  return smoothness;
}

// D^(2-order) W = z'.
Smoothness integrated_start_above_one(const MotionPowers& powers, double order, Eigen::Index coordinates) {
  Smoothness smoothness;
  add(smoothness, coordinates, shifted(powers.velocity, 1.0));
  add(smoothness, coordinates, powers.free_part);
  add(smoothness, 1, without(powers.velocity, 0.0));
  add(smoothness, coordinates, shifted(powers.free_part, 1.0 - order));
  return smoothness;
}

}  // namespace fde::mechanics
