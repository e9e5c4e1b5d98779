#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace fde {

struct DiffusiveOptions {
  int stages = 8;             // of the Radau IIA method, 2 ... 16
  double tolerance = 1e-10;   // of the last Legendre coefficients of y and f on a step, relative to the size
                              // of y so far; the end of a step is as accurate as rounding allows then
  double first_step = 1e-20;  // relative to the end
  double weightless = 1e-18;  // of the end: an error of f before it is lost in rounding later on
};

// A solution at the ends of the steps.
struct DiffusiveSolution {
  std::vector<double> times;  // increasing, without 0; the stops and the end among them
  std::vector<Vec> values;
};

// A second method beside the collocation, which shares nothing with it: the memory is a sum of exponentials,
// which turns the system into ordinary differential equations (the idea of Guglielmi & Hairer, arXiv
// 2506.04188, 2025), and a Radau IIA method integrates these. Steps double and halve with what the stages
// resolve, so they grow geometrically away from 0. Orders in (0, 2]; stops: increasing times in (0, end].
// Throws std::invalid_argument naming the component and its order for others, std::runtime_error naming the
// time where no step converges.
DiffusiveSolution diffusive_solution(const Problem& problem, const DiffusiveOptions& options = {},
                                     const std::vector<double>& stops = {});

}  // namespace fde
