// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// Problems begin at 0: schemes, references and measures count time from Scene::start. Requests that read and
// print the times of users translate with these functions.

// The end of the time interval as users read it.
double end_time(const Scene& scene);

// A time of users counted from the start, and a time counted from there as users read it. Sums and
// differences are those of the decimals that the numbers print: 0.3 is 0.2 after a start of 0.1.
double from_start(const Scene& scene, double time);
double from_zero(const Scene& scene, double after_start);

// A message in which times are counted from the start; it says so unless the start is 0.
std::string with_note_of_start(const Scene& scene, std::string message);

// Throws std::invalid_argument unless the start is 0. `what` takes other starts not, as "run".
void require_start_at_zero(const Scene& scene, std::string_view what);

}  // namespace fde::bench
