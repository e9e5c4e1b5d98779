#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"
#include "stepping/events.hpp"

namespace fde {

using Rows = Matrix;  // one row a component, one column a time

// How a run ended. A scheme returns one of the first ten; the others follow from a comparison with the
// reference.
enum class Ending {
  finished,
  not_finite,
  not_converged,   // Newton's method
  outran_growth,   // a mode of the problem grows so fast that a step leads through infinity
  step_too_small,  // the error test failed down to the smallest step
  blow_up,         // the solution grows without bound as time nears a finite one
  sliding,         // the state stays on a switch of the right-hand side: no solution leads away from it
  singular,        // left the domain of its problem
  out_of_budget,
  event,               // one of Options::events has ended it, as was asked
  accuracy_lost,       // finished, but see accuracy_lost()
  overflow,            // finished where the solution itself is infinite
  no_reference,        // finished, and there is nothing to compare with
  passed_singularity,  // finished beyond a singularity of the solution
  false_singularity,   // singular, and the solution is not
  program_failed,      // of another program, which came to no end of its own or wrote no trajectory
  refused,             // did not begin
};

// What a run used, apart from time. What was not counted is absent.
struct Cost {
  std::optional<std::int64_t> rhs_calls{}, newton_iterations{};
  std::optional<std::size_t> history_bytes{};
  // Components actually stepped; more than the problem's where a scheme splits orders.
  std::optional<int> states{};
  std::optional<int> start_weights{};            // of f_0, f_1, ... at every step
  std::optional<std::int64_t> rejected_steps{};  // attempted and not taken
  std::string_view linear_solver{};              // of sparse equations; empty: there were none
};

// What a scheme returns: y at the times that were asked for, otherwise at its own, as far as the run came.
struct Trajectory {
  std::vector<double> times{};           // increasing
  Rows y{};                              // y.col(c) belongs to times[c]
  std::function<Vec(double t)> dense{};  // y at any time up to `reached`; empty: not known between times
  std::vector<Occurrence> events{};      // zeros of Options::events, in the order of time
  Ending ending = Ending::finished;      // how the run ended
  double reached = 0.0;                  // the last time with a result, asked for or not
  std::optional<double> failed_at{};     // the time of the step that has no result, where one failed
  std::optional<double> residual{};      // of all times at once, where Newton's method left it
  std::int64_t steps = 0;                // with a result; 0 where nothing was stepped
  Cost cost{};
  std::vector<Trajectory> others{};  // further solutions, where Options::all_solutions asks for them

  // Of this column of y.
  [[nodiscard]] double time(Eigen::Index column) const { return times[static_cast<std::size_t>(column)]; }
};

}  // namespace fde
