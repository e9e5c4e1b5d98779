#pragma once

#include <complex>
#include <vector>

#include "truth.hpp"

namespace fde {

// One term coefficient * time_scale^order * D^order u of a linear equation; order 0 is u itself. The power is
// taken at the precision asked for, where a product in double would be off after 16 digits.
struct LinearTerm {
  std::complex<double> coefficient;
  double order;
  double time_scale = 1.0;
};

// A load coefficient * t^power (power > -1) that acts from t = from on, as coefficient * (t - from)^power.
struct Load {
  double coefficient;
  double power = 0.0;
  double from = 0.0;
};

// sum_i c_i D^(order_i) u = sum_k load_k(t): Caputo derivatives from 0, orders in [0, 2], u^(k)(0) =
// initial[k]. Terms with coefficient 0 do not count; ceil(highest order) initial values are needed.
struct LinearEquation {
  std::vector<LinearTerm> terms;
  std::vector<std::complex<double>> initial;
  std::vector<Load> loads{};
};

// D^order u for each of the orders (0: u itself), as an exact solution: components are those derivatives in
// turn. For the complex pair the components are instead Re u, Im u (a complex u stands for a real 2x2
// system), and their bounds are of |error of u|. Inverse Laplace transform: residues at the zeros of sum_i
// c_i s^(order_i) on the principal sheet, and a contour round the branch cut on the negative axis. Where a
// load sets in, and at t = 0, the value is the limit from the right, which may be infinite. Accuracy is
// relative to each value, down to 1e-40 of the terms it is the sum of. Throws std::invalid_argument for an
// equation that is not posed like this, or a time that is negative or not finite, and std::runtime_error
// where the zeros cannot all be found.
Exact exact_solution(const LinearEquation& equation, const std::vector<double>& orders);
Exact exact_solution_complex_pair(const LinearEquation& equation);

// One term coefficient * t^(power + multiple * order), the exponent put together at the precision asked for.
struct Power {
  double coefficient, power, multiple = 0.0;
};

// Their sum, with its digits: for problems made from a known solution.
Exact exact_power_sum(const std::vector<Power>& terms, double order = 0.0);

}  // namespace fde
