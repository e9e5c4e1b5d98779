// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"

namespace fde::bench::mechanics {
namespace {

bool is_above_one(const Dynamics& dynamics) {
  const auto orders = dynamics.constraint_orders();
  return !orders.empty() && *orders.rbegin() > 1.0;
}

PosedEquations posed_above_one(const Dynamics& dynamics, Formulation formulation) {
  if (formulation == Formulation::integrated) return integrated_above_one(dynamics);
  if (formulation == Formulation::multiplier) return multiplier_above_one(dynamics);
  return {.ill_posed_reason =
              fmt::format("formulation = {}: must be integrated or multiplier for alpha = {}: above 1 the "
                          "highest derivative is D^(1+alpha) q inside the reaction",
                          name_of(formulation), *dynamics.constraint_orders().rbegin())};
}

}  // namespace

PosedEquations posed(const Dynamics& dynamics, const FormulationChoice& choice) {
  if (is_above_one(dynamics)) return posed_above_one(dynamics, choice.formulation);
  switch (choice.formulation) {
    case Formulation::integrated:
      return integrated_equations(dynamics);
    case Formulation::multiplier:
      return multiplier_equations(dynamics);
    case Formulation::acceleration:
    case Formulation::stabilised:
      break;
  }
  return acceleration_equations(dynamics, choice.kappa);
}

Formulation reference_formulation(const Dynamics& dynamics) {
  const bool above_one = is_above_one(dynamics);
  const bool is_integrated = above_one ? integrated_above_one(dynamics).ill_posed_reason.empty()
                                       : !dynamics.force_order_with_memory_rates();
  if (dynamics.is_affine() && is_integrated) return Formulation::integrated;
  const bool is_accelerated = !above_one && acceleration_equations(dynamics, 0.0).ill_posed_reason.empty();
  return is_accelerated ? Formulation::acceleration : Formulation::multiplier;
}

std::string refused_as_memory_rate(double order) {
  return fmt::format(
      "formulation = integrated: must be multiplier, acceleration or stabilised where a force contains a "
      "derivative of order {} beside one of an order below 1 in a constraint",
      order);
}

std::string refused_as_singular(Formulation formulation, double order) {
  return fmt::format(
      "formulation = {}: must be neither acceleration nor stabilised for alpha = {}: "
      "v' starts like t^-alpha unless (df/dw) v(0) = 0, which they take for alpha < 1/2 only",
      name_of(formulation), order);
}

std::string refused_as_unbounded_force(Formulation formulation, double order) {
  return fmt::format(
      "formulation = {}: must be multiplier: v' is unbounded at t = 0, and a force contains a derivative of "
      "order {}",
      name_of(formulation), order);
}

std::string refused_as_unaligned(double order) {
  return fmt::format(
      "formulation = integrated: must be multiplier for alpha = {} and a.b = 0: above "
      "1 the constraint then fixes no derivative of order alpha",
      order);
}

}  // namespace fde::bench::mechanics
