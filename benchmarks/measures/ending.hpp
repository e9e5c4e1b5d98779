#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "problem/grid.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// How a run ended, and the rest of the sentence that says it: "at step 94, t = 18.4", or a reason.
struct RunEnding {
  Ending kind = Ending::finished;
  std::string detail{};

  bool operator==(const RunEnding&) const = default;
};

// "not_finite", as results name it, and back; nullopt: there is no such ending.
std::string_view name(Ending ending);
std::optional<Ending> ending_named(std::string_view name);

// For people: "not finite at step 94, t = 18.4"; "refused: needs a uniform grid"; "finished".
std::string sentence(const RunEnding& ending);

// Whether the run was compared with the reference, all the way: such a run is timed.
bool is_compared(Ending ending);

// How a scheme's run of the problem ended, with step and time where it ended early.
RunEnding ending_of(const Problem& problem, const Trajectory& path);
std::string describe(const Problem& problem, const Trajectory& path);  // as a sentence

// "at step N, t = T"; "at t = T" where it is not known to be a step of a grid.
std::string at_step(std::int64_t step, double t);
std::string at_time(const std::optional<Grid>& grid, double t);

}  // namespace fde
