// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// A run with its settings, and the quantities in which it is compared with others: the components of y, and
// functions of the state that follow them, such as an energy.
struct SolvedRun {
  const Scheme& scheme;
  const Problem& problem;
  const Grid& grid;
  const Options& options;
  const Trajectory& path;
  std::vector<std::string> names{};  // of the quantities, for the text; "" or too few: those have none
  std::function<Vec(double t, In y)> functions{};

  [[nodiscard]] std::string name(Eigen::Index quantity) const;
  // The quantities at a time of this or another path of the same problem, interpolated between its times.
  [[nodiscard]] Vec quantities(const Trajectory& of, double t) const;
};

// What the scheme makes of the same problem with another number of steps, in the last quarter of the steps.
// All numbers are parts of the value: of the largest size there, of each quantity its own.
enum class Agreement { agrees, differs, unknown };
struct ComparedSteps {
  Agreement agreement = Agreement::unknown;
  std::string numbers{};  // where it differs: both values and their numbers of steps
};

// An error of more than this part of the value is worth a warning.
inline constexpr double significant_part = 0.1;

// Short runs are compared with 4 to 16 times as many steps, whose error is a fraction of theirs. Of longer
// ones this would take too long: they are compared with two coarser runs, n and n/2 steps, from a 64th of the
// steps on to half of them. With D_0 the difference of the run from the finer one of the two, which has 1/r
// of the steps, and D_1 that of the two, the error is taken to fall like N^-p, so that
//   D_1 / D_0 = (2^p - 1) / (1 - r^-p),  error = D_0 / (r^p - 1),  1/2 <= p <= 2.
// Where that does not decide, a run with four times as many steps does, if the run is not very long; of
// longer runs the estimate decides. It is unknown where half of the steps give nothing that can be compared.
ComparedSteps compare_with_other_steps(const SolvedRun& run);

// With half the steps; differs where the difference itself is above significant_part.
ComparedSteps compare_with_half_the_steps(const SolvedRun& run);

// The largest product of steps and components for which another run, as long or longer, is solved to decide.
inline constexpr Eigen::Index longest_settled = 32768;

// The same problem by a scheme on a grid, stored at these times, or at those of the grid beside them.
Trajectory solve_again(const SolvedRun& run, const Scheme& scheme, const Grid& grid,
                       const std::vector<double>& times);

// Of each quantity the largest size in the last quarter of the steps; at least what rounding leaves of its
// own and of all quantities' largest at spread_times.
Vec late_sizes(const SolvedRun& run);

// The times that a run has to store for these.
std::vector<double> times_compared(const Problem& problem, const Grid& grid);

// These times where the grid has them, otherwise those of the grid on both sides; in increasing order.
std::vector<double> grid_times_at(const Grid& grid, const std::vector<double>& times);

// y of a run that stored the grid times at t, interpolated between them.
Vec stored_at(const Trajectory& path, double t);

// The last and some times before it, in the last quarter of the steps.
std::vector<double> late_times(const Grid& grid);

// The start and three times spread over the steps.
std::vector<double> spread_times(const Grid& grid);

// The last four times, or as many as there are.
std::vector<double> last_times(const Grid& grid);

}  // namespace fde
