#pragma once

#include <vector>

#include "load.hpp"
#include "problem.hpp"
#include "truth.hpp"

namespace fde {

// D^(orders[i]) x_i = sum_j matrix(i, j) x_j + sum_k loads[i][k](t): Caputo derivatives from 0, orders above
// 0, x_i^(k)(0) = initial[i][k] for k < ceil(orders[i]). Up to 8 components; loads may be empty.
struct LinearSystem {
  std::vector<double> orders;
  std::vector<std::vector<double>> initial;
  Matrix matrix;
  std::vector<std::vector<Load>> loads{};
};

// All components, as an exact solution; see linear_solution.hpp for what it is good to. Throws
// std::invalid_argument for a system that is not posed like this.
Exact exact_solution(const LinearSystem& system);

}  // namespace fde
