// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/reference/nonlinear/march/reset_locator.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

struct DiffusiveOptions {
  int stages = 8;  // of the Radau IIA method, 2 ... 16
  // Of the last Legendre coefficients of y and f on a step, relative to the size of y so far; the error at
  // the end of a step is then rounding.
  double tolerance = 1e-10;
  double first_step = 1e-20;  // relative to the end
  // Relative to the end: errors of f before this time are below rounding later.
  double negligible_before = 1e-18;
  // The problem, which looks back at this solution; nullptr: it has no delays.
  BoundProblem* looking_back = nullptr;
};

// A solution at the ends of the steps.
struct DiffusiveSolution {
  std::vector<double> times;  // increasing, without 0, with the stops, the events and the end
  std::vector<Vec> values;    // at an event before y jumps
  std::vector<ResetEvent> events;
  std::optional<ResetEvent> event_at_end;  // ResetLocator::next_to at the end
};

// A second method besides the collocation, with a different discretisation: the kernel is a sum of
// exponentials, which turns the system into ordinary differential equations (the idea of Guglielmi & Hairer,
// arXiv 2506.04188, 2025), and a Radau IIA method integrates these. Step sizes double and halve such that the
// stages resolve the solution, so they grow geometrically away from 0. stops: increasing times in (0, end].
// Throws std::invalid_argument for a problem that require_supported() rejects, std::runtime_error naming the
// time where no step converges or too many are needed, or beyond ResetLocator::most_events. Where an event
// sets y, located on the polynomial through the stages, a step ends and y jumps.
DiffusiveSolution diffusive_solution(const Problem& problem, const DiffusiveOptions& options = {},
                                     const std::vector<double>& stops = {});

}  // namespace fde::reference
