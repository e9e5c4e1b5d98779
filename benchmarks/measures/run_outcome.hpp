// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// What the comparison with the reference says of a run, where that differs from the status of its solver.
enum class Verdict {
  accuracy_lost,       // finished with an error as large as the value up to the end
  overflow,            // finished where the solution itself is infinite
  no_reference,        // finished, without a reference to compare with
  passed_singularity,  // finished after a singularity of the solution
  false_singularity,   // left the domain, although the solution does not
  program_failed,      // an external program crashed, was ended or wrote no trajectory
};

// How a run ended: the status of its solver, or the verdict that replaces it. In results of another version
// of fdebench it may be another one, which has a name only.
class OutcomeKind {
 public:
  constexpr OutcomeKind(SolveStatus status) : value_(status) {}
  constexpr OutcomeKind(Verdict verdict) : value_(verdict) {}
  explicit OutcomeKind(std::string unknown) : value_(std::move(unknown)) {}
  bool operator==(const OutcomeKind&) const = default;

  // The name of an outcome of another version; nullptr for all others.
  [[nodiscard]] const std::string* unknown() const { return std::get_if<std::string>(&value_); }

 private:
  std::variant<SolveStatus, Verdict, std::string> value_;
};

// How a run ended and the continuation of its sentence: "at step 94, t = 18.4", or a reason.
struct RunOutcome {
  OutcomeKind kind = SolveStatus::finished;
  std::string detail{};

  bool operator==(const RunOutcome&) const = default;
};

// "not_finite", as in results files, and the inverse. The name of an outcome is valid while `kind` lives.
std::string_view name(const OutcomeKind& kind);
OutcomeKind outcome_named(std::string_view name);

// For display: "not finite at step 94, t = 18.4"; "refused: needs a uniform grid"; "finished".
std::string sentence(const RunOutcome& outcome);

// Whether the run has been compared with the reference up to its end: such a run is timed.
bool is_compared(const OutcomeKind& kind);

// How a run of a scheme ended, with step and time if it ended early.
RunOutcome outcome_of(const Problem& problem, const Trajectory& path);
std::string describe(const Problem& problem, const Trajectory& path);  // as a sentence

// "at step N, t = T"; without a grid "at t = T".
std::string at_step(std::int64_t step, double t);
std::string at_time(const std::optional<Grid>& grid, double t);

}  // namespace fde::bench
