#pragma once

#include <string>
#include <string_view>

#include "trajectory.hpp"

namespace fde {

// How a run of a sweep ended, in a word. The status of its outcome row says it in a sentence, which begins
// with the words of the ending; these are written and read here only.
enum class Ending {
  finished,       // and compared with the truth
  accuracy_lost,  // the same, but see accuracy_lost()
  beyond_double,  // finished where the solution itself is infinite
  no_reference,   // finished, and there is no truth to compare with
  singular,       // stopped where the solution has a singularity
  failed,         // stopped elsewhere, or passed a singularity
  refused,        // did not begin
};

// The words with which a status of this ending begins; of a failure none.
std::string_view words(Ending ending);
Ending ending_of(std::string_view status);

// Whether the run was compared with the truth, all the way: such a run is timed.
bool is_compared(Ending ending);

// Why a run of the problem ended early, with step and time: "not finite at step 94, t = 18.4"; "finished"
// when it did not.
std::string describe(const Problem& problem, const Trajectory& path);

// "WHAT at step N, t = T".
std::string at_step(std::string_view what, const Grid& grid, int step);

}  // namespace fde
