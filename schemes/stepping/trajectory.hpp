// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "fdebench/schemes/history/history_kind.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

class Archive;

// An event function, located where it changes its sign along the solution. A zero at t = 0 does not count,
// nor does a zero without a change of sign. The function does not influence the solution.
struct Event {
  std::function<double(double t, In y)> value{};
  Crossing crossing = Crossing::either;  // zeros in the other direction do not count
  bool terminal = false;                 // whether the first zero that counts ends the run
  // The time of the last jump of y, where the value may change its sign without a zero; empty: there is none.
  std::function<double()> last_jump{};
  // Times, increasing, at which the function is looked at besides: where it depends on t alone, one between
  // any two of its zeros.
  std::vector<double> times{};
};

// A zero of an event function, with y at its time.
struct EventOccurrence {
  std::size_t event;  // index in Options::events
  double t;
  Vec y;

  void state(Archive& archive);
};

// y within a step of a scheme with dense output. Events are located from samples at the ends of `pieces`
// pieces.
struct StepInterpolant {
  std::function<Vec(double t)> at;
  int pieces = 8;
};

using Rows = Matrix;  // one row a component, one column a time

// How a solve ended.
enum class SolveStatus {
  finished,
  non_finite,
  not_converged,   // Newton's method did not converge
  undetermined,    // the conditions at both ends do not determine the unknown initial values
  step_too_large,  // the step is too large for a growing mode: its amplification passes through infinity
  step_too_small,  // the error test failed down to the smallest step size
  blow_up,         // the solution grows without bound as time nears a finite one
  sliding,         // the state stays on a switching surface, no solution leaves it (Filippov sliding)
  left_domain,     // the state left the domain of the problem, at a singularity of its right-hand side
  out_of_budget,
  terminal_event,  // an event with Event::terminal ended the run
  refused,         // the run was not started
};

// The cost of a run apart from time. A quantity that was not counted is nullopt.
struct Cost {
  std::optional<std::int64_t> rhs_calls{}, newton_iterations{};
  std::optional<std::size_t> history_bytes{};
  std::optional<ChosenHistory> history{};  // of a run on a grid; nullopt: there was none
  // Number of components that were integrated; more than the problem has where a scheme splits orders.
  std::optional<int> components{};
  std::optional<int> starting_weights{};         // their number in every step: those of f_0, f_1, ...
  std::optional<std::int64_t> rejected_steps{};  // attempted and rejected
  std::string_view linear_solver{};              // for sparse systems; empty: there were none
};

// The result of a scheme: y at the output times, by default at all of its own times, up to `last_time`.
struct Trajectory {
  std::vector<double> times{};                  // increasing
  Rows y{};                                     // y.col(c) belongs to times[c]
  std::function<Vec(double t)> dense_output{};  // y at any 0 <= t <= last_time; empty: not available
  std::vector<EventOccurrence> events{};        // zeros of Options::events, by increasing time
  SolveStatus status = SolveStatus::finished;
  double last_time = 0.0;                // the last time with a result, also where it is no output time
  std::optional<double> failure_time{};  // the end of the step that failed; nullopt: none did
  std::optional<double> residual{};  // the last one of Newton's method for all times, or of the conditions
  std::int64_t steps = 0;            // number of steps with a result
  Cost cost{};
  std::vector<Trajectory> other_solutions{};  // further solutions with Options::all_solutions

  // The time of this column of y.
  [[nodiscard]] double time(Eigen::Index column) const { return times[static_cast<std::size_t>(column)]; }
};

}  // namespace fde
