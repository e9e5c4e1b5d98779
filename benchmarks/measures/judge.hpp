// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/column_errors.hpp"
#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The assessment of a run: how and when it ended, and every measure that applies.
struct Assessment {
  RunOutcome ending{};
  double end_time = 0.0;  // time at which it stopped or lost its accuracy; otherwise the end
  std::vector<MeasuredValue> measured{};
  ColumnErrors columns{};
};

// Judges a trajectory of the scene, with at least one time, by the scene's reference. There are no measures
// if the run stopped, or if a column, the reference or a measure is not finite. Without a reference only
// the measures that need none are taken.
Assessment judge(const Scene& scene, const Trajectory& path, MemoizedReference& reference,
                 const RunObservations& observed = {});

// The same with the columns given at path.times, one column a time, in place of the states in the path.
Assessment judge(const Scene& scene, const Trajectory& path, const Rows& columns,
                 MemoizedReference& reference, const RunObservations& observed);

// The same for the columns of the scene at given times, one column a time, such as the output of another
// program. The run counts as finished. `compared`: names of the columns, if their errors are wanted one by
// one.
struct ComparedColumns {
  std::vector<std::string> names{};
  bool is_part = false;  // the scene has other columns, too
};
Assessment judge_columns(const std::vector<double>& times, const Rows& columns, MemoizedReference& reference,
                         const RunObservations& observed = {}, const ComparedColumns& compared = {});

}  // namespace fde::bench
