// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/printed_table.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {

// A run that did not come to its end.
struct RunFailure : NumericalFailure {
  RunFailure(const std::string& message, std::string_view scheme_id, const Trajectory& path)
      : NumericalFailure(message), scheme(scheme_id), step(path.steps + 1), time(path.failure_time) {}
  std::string scheme;
  std::int64_t step;           // without a result
  std::optional<double> time;  // of that step
};

// Solves a scene. A checkpoint that cannot be written is not thrown but said. `show` is called now and then
// with the progress of the run. Throws std::invalid_argument
// naming the argument, the text and what is allowed, RunFailure, and NumericalFailure where a column is not
// finite.
SolvedTable solved_table(const Scene& scene, const RunArguments& arguments,
                         const std::function<void(const std::string&)>& say = {},
                         const std::function<void(const Progress&)>& show = {});

}  // namespace fde::bench
