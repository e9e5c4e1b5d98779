// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// One row of a problem with the manufactured solution y_i = 1 + i/4 + s^power, with s = t in a left row and s
// = end - t in a right row.
struct ManufacturedRow {
  double order, power;
  Side side;
};

// A manufactured problem with its exact solution y(t) and smoothness.
struct ManufacturedProblem {
  Problem problem;
  std::function<Vec(double)> exact;
  Smoothness smoothness;
};

// The problem D^g y_i = f_i with f_i = D^g s^p + N_i(y) - N_i(exact), D^g s^p = Gamma(p+1)/Gamma(p+1-g)
// s^(p-g) on both sides; each row is coupled to the next two by N_i(y) = sin(y_(i+1)) y_(i+2) / 2 - y_i.
ManufacturedProblem manufactured_problem(const std::vector<ManufacturedRow>& rows, double end);

// Six rows, three of each side, with orders below, at and above 1 and smooth solutions.
ManufacturedProblem smooth_two_sided();

}  // namespace fde::bench
