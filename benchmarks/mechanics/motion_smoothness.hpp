// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/posed_formulations.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench::mechanics {

// The powers of t with which the rows of a formulation start: for a linear problem without explicit time
// those of its series, otherwise all that may occur. Empty if L, F or f is not smooth at the start. Rows
// D^order v are not measured.
Smoothness motion_smoothness(const Dynamics& dynamics, const PosedEquations& equations,
                             const Problem& problem);

// The powers, without the constant, of the derivative of order `order` of functions with these powers.
std::vector<double> powers_of_derivative(const std::vector<double>& powers, double order);

}  // namespace fde::bench::mechanics
