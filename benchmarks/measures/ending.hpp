#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fdebench/schemes/problem/grid.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// How a run ended and the continuation of its sentence: "at step 94, t = 18.4", or a reason.
struct RunOutcome {
  Ending kind = Ending::finished;
  std::string detail{};

  bool operator==(const RunOutcome&) const = default;
};

// "non_finite", as in results files, and the inverse; nullopt: no ending has this name.
std::string_view name(Ending ending);
std::optional<Ending> ending_named(std::string_view name);

// For display: "not finite at step 94, t = 18.4"; "refused: needs a uniform grid"; "finished".
std::string sentence(const RunOutcome& ending);

// Whether the run has been compared with the reference up to its end: such a run is timed.
bool is_compared(Ending ending);

// How a run of a scheme ended, with step and time if it ended early.
RunOutcome ending_of(const Problem& problem, const Trajectory& path);
std::string describe(const Problem& problem, const Trajectory& path);  // as a sentence

// "at step N, t = T"; without a grid "at t = T".
std::string at_step(std::int64_t step, double t);
std::string at_time(const std::optional<Grid>& grid, double t);

}  // namespace fde
