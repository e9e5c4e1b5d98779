// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/requests/recommendation.hpp"
#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// A recommendation from recorded runs. If no run is within the accuracy, `missing` explains what is.
Recommendation recommend(const Runs& runs, const SceneSettings& scene, const ErrorKind& kind,
                         double accuracy);

}  // namespace fde::bench
