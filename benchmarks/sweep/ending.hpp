#pragma once

#include <string>
#include <string_view>

#include "problem/resolution.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// The status of an outcome row says how a run ended in a sentence, which begins with the words of the
// ending; these are written and read here only.

// The words with which a status of this ending begins; of a failure none.
std::string_view words(Ending ending);
Ending ending_of(std::string_view status);

// Whether the run was compared with the reference, all the way: such a run is timed.
bool is_compared(Ending ending);

// Why a run of the problem ended early, with the step and time that failed: "not finite at step 94, t =
// 18.4"; "finished" when it did not.
std::string describe(const Problem& problem, const Trajectory& path);

// "WHAT at step N, t = T".
std::string at_step(std::string_view what, std::int64_t step, double t);

// The same for a time of a run; "WHAT at t = T" where it chose its times itself.
std::string at_time(std::string_view what, const Resolution& resolution, double t);

}  // namespace fde
