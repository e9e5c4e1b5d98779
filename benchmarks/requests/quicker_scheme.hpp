// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <string_view>
#include <thread>

#include "fdebench/benchmarks/requests/requested_run.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A solve of the same problem by a scheme with adaptive step size, in less than a hundredth of the time that
// a run has taken.
struct QuickerScheme {
  std::string_view scheme;  // its id
  double accuracy;          // that of the run; 1e-8 for one over a grid
  std::chrono::duration<double> seconds, seconds_of_run;
};

// Looks for a quicker scheme in a thread of its own while a run goes on, until the result is destroyed: once
// the run has taken `first`, and whenever it has taken four times as long again, each scheme that takes the
// problem may try for a hundredth of that time, so that the search costs some hundredths of the run. Calls
// `found` at most once, in that thread. Problems with more than a hundred unknowns are left, as their
// matrices may need much memory. Scene and run must outlive the result.
std::jthread quicker_scheme_search(const Scene& scene, const RequestedRun& run,
                                   std::chrono::duration<double> first,
                                   std::function<void(const QuickerScheme&)> found);

}  // namespace fde::bench
