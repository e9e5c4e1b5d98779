// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/benchmarks/fit/goodness.hpp"
#include "fdebench/benchmarks/records/external_trajectory.hpp"

namespace fde::bench {

// A trajectory in a file or a pipe; - is standard input. Throws as read_trajectory() does, and for a pipe of
// more than 2^30 bytes.
ExternalTrajectory read_data(const std::string& file, const Scene& scene,
                             TrajectorySource source = TrajectorySource::computed);

// chi^2, its degrees of freedom and its probability, a line each.
std::string text_of(const ChiSquared& chi_squared);

}  // namespace fde::bench
