#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/events.hpp"

namespace fde {

using Rows = Matrix;  // one row a component, one column a time

// How a run ended. A scheme returns one of the first ten; the others are set by callers, most of them after a
// comparison with the reference.
enum class Ending {
  finished,
  non_finite,
  not_converged,   // Newton's method did not converge
  step_too_large,  // the step is too large for a growing mode: its amplification passes through infinity
  step_too_small,  // the error test failed down to the smallest step size
  blow_up,         // the solution grows without bound as time nears a finite one
  sliding,         // the state stays on a switching surface, no solution leaves it (Filippov sliding)
  singular,        // the state left the domain of the problem
  out_of_budget,
  event,               // an event with Event::ends ended the run
  accuracy_lost,       // finished with an error as large as the value up to the end
  overflow,            // finished where the solution itself is infinite
  no_reference,        // finished, without a reference to compare with
  passed_singularity,  // finished after a singularity of the solution
  false_singularity,   // singular, although the solution has no singularity there
  program_failed,      // an external program crashed, was ended or wrote no trajectory
  refused,             // the run was not started
};

// The cost of a run apart from time. A quantity that was not counted is nullopt.
struct Cost {
  std::optional<std::int64_t> rhs_calls{}, newton_iterations{};
  std::optional<std::size_t> history_bytes{};
  // Number of components that were integrated; more than the problem has where a scheme splits orders.
  std::optional<int> states{};
  std::optional<int> start_weights{};            // starting weights (of f_0, f_1, ...) in every step
  std::optional<std::int64_t> rejected_steps{};  // attempted and rejected
  std::string_view linear_solver{};              // for sparse systems; empty: there were none
};

// The result of a scheme: y at the output times, by default at all of its own times, up to `reached`.
struct Trajectory {
  std::vector<double> times{};            // increasing
  Rows y{};                               // y.col(c) belongs to times[c]
  std::function<Vec(double t)> dense{};   // dense output, 0 <= t <= reached; empty: not available
  std::vector<EventOccurrence> events{};  // zeros of Options::events, by increasing time
  Ending ending = Ending::finished;
  double reached = 0.0;                  // the last time with a result, also where it is no output time
  std::optional<double> failure_time{};  // the end of the step that failed; nullopt: none did
  std::optional<double> residual{};      // the last residual, where Newton's method for all times failed
  std::int64_t steps = 0;                // number of steps with a result
  Cost cost{};
  std::vector<Trajectory> others{};  // further solutions with Options::all_solutions

  // The time of this column of y.
  [[nodiscard]] double time(Eigen::Index column) const { return times[static_cast<std::size_t>(column)]; }
};

}  // namespace fde
