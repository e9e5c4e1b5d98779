// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"

namespace fde::bench {

// One error of a run, of one kind of error: the largest of the compared values.
struct RunError {
  double value = std::numeric_limits<double>::infinity();  // infinity: the run has none
  // The smaller error of y = 0 and of y = y(0), which a run has to be below; infinity: not known to matter.
  double baseline = std::numeric_limits<double>::infinity();
  bool is_stagnant = false;      // dominated by rounding or by the error of the reference
  double signed_value = 0.0;     // the error with its sign, where it is of one number; otherwise 0
  Eigen::Index column = 0;       // index of the scene's column with this error, where it is known,
  double time = 0.0;             // and when
  double reference_bound = 0.0;  // of the compared values, the largest, on the scale of the error

  bool operator==(const RunError&) const = default;
};

// One run of a refinement, measured or forecast.
struct RefinementRun {
  StepsOrTolerance resolution = 1;
  int steps = 0;  // taken
  // Of one solve, of all its steps where it grew beyond all numbers before; nullopt: not timed.
  std::optional<double> seconds{};
  double setup_seconds = 0.0;     // by which the first solve of a process takes longer, if known
  bool first_run = false;         // `seconds` is of the first solve of a process, otherwise of a later one
  bool is_whole_process = false;  // `seconds` is the time of a whole process
  bool fails_with_more_steps = false;  // more steps fail alike: refused, no reference, a singularity, ...
  RunOutcome ending{};
  std::vector<RunError> errors{};  // one entry for each kind of error of the search

  // The part of `seconds` that does not grow with the steps.
  [[nodiscard]] double counted_setup() const { return first_run ? setup_seconds : 0.0; }
  // The error of the first kind. Precondition: the run has errors.
  [[nodiscard]] const RunError& error() const { return errors.front(); }
};

// The runs so far of one configuration (a scheme with a grading, or with adaptive step size) on a scene.
struct Refinement {
  bool is_adaptive = false;
  bool is_closed = false;  // no further run is wanted: the scheme refuses the problem, or repeats another
  int unit = 1;            // numbers of steps are multiples of it
  std::vector<RefinementRun> runs{};  // in the order in which they were made

  // Appends a run, or replaces one with the same tolerance, which ended for want of time. Fewer steps of one
  // scheme take no longer: a longer time is that of a disturbed run, so a run over a grid that ended takes at
  // most the time of each such run with more steps.
  void add(RefinementRun run);

  // The run over the grid with the most steps, or with the smallest tolerance; nullptr: no run.
  [[nodiscard]] const RefinementRun* finest() const;
};

// The error of this kind; infinity where the run has none.
RunError error_of(const RefinementRun& run, std::size_t kind);

// A requested accuracy: errors[kind].value <= error.
struct ErrorTarget {
  std::size_t kind = 0;
  double error = 0.0;
  bool may_pass_zero = false;  // an error at one time, which is small by chance for some numbers of steps
};

// Whether the run is within the target and better than a constant.
bool is_within(const RefinementRun& run, const ErrorTarget& target);

// The quickest timed run within the target, of equally quick ones that with the fewest steps; nullptr if
// there is none.
const RefinementRun* quickest_within(const Refinement& of, const ErrorTarget& target);

// The finite errors over grids with at most `most` steps, from coarse to fine, at numbers of steps that
// differ by a factor of nearly two or more: neighbouring numbers say little about the rate.
std::vector<TrialError> doubled_errors(const Refinement& of, std::size_t kind,
                                       int most = std::numeric_limits<int>::max());

// Whether the three finest errors, far below the size of the solution, no longer decrease, or the finest one
// is known to be stagnant.
bool has_stagnated(const Refinement& of, std::size_t kind);

// The seconds of a run that do not grow with the steps: counted_setup(), or what it takes to start an
// external program, by its shortest run.
double start_seconds(const Refinement& of);

// The forecast seconds of a run over a grid with this many steps: the least time per step among the three
// finest timed runs, because other load on the machine makes a measured time too long and never too short;
// longer runs take more per step where the last two, of a millisecond or more, show it. nullopt if no run is
// timed.
std::optional<double> seconds_with(const Refinement& of, double steps);

// The model of the errors of one kind over grids; empty with fewer than three above rounding, or if none
// decreases.
ErrorModel error_model(const Refinement& of, std::size_t kind);

// The forecast seconds of the quickest run within the target: over grids by this model of errors of the
// target's kind and by seconds_with(); with tolerances as a power of the error. nullopt without a model, or
// without two errors that are far enough apart.
std::optional<Prediction> forecast_seconds(const Refinement& of, const ErrorTarget& target,
                                           const ErrorModel& model);

// Whether two configurations are one algorithm on this scene: their errors are equal bit for bit, and not 0,
// at every number of steps that both were run with, at least `fewest`.
inline constexpr int fewest_equal_runs = 5;
bool is_same_algorithm(const Refinement& a, const Refinement& b, int fewest = fewest_equal_runs);

}  // namespace fde::bench
