// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/benchmarks/search/error_estimate.hpp"

namespace fde::bench {

// Factor between error and difference where the difference d decreased by `ratio` with each doubling of N. An
// error ~ N^-p that changes by d from N/2 to N is d / (2^p - 1), ratio = 2^p; at least d is taken, times a
// safety factor of 4. Infinity for ratio <= 1.
double estimate_factor(double ratio);

// Largest estimated error of the replaced reference, as a fraction of the requested accuracy.
inline constexpr double largest_estimate_fraction = 0.1;

// The reference of a search, with the estimate it rests on if it is not a known reference.
struct SearchReference {
  reference::Reference reference{};
  std::optional<ErrorEstimate> estimate{};
};

// The reference of the scene; if there is none, an estimate with error <= largest_estimate_fraction *
// accuracy, computed within `seconds`. Two configurations of different schemes are chosen whose results
// change least from N/2 to N among those that reach the end time with few steps, one implicit and one
// explicit if possible. Both double their steps until the estimated error is small enough; the factor uses
// the smaller of the last two ratios of successive differences. For Norm::end they are compared over the last
// tenth of the interval. Throws Singularity if a singularity is the reason for the missing reference, and
// std::runtime_error with both reasons if the two runs do not agree in time.
SearchReference reference_or_estimate(const Scene& scene, const AccuracyTarget& target, double seconds,
                                      const SearchProgress& progress);

// The estimate alone, for a scene that has no reference for the reason `no_reference_reason`.
SearchReference estimated_reference(const Scene& scene, const AccuracyTarget& target,
                                    const std::string& no_reference_reason, double seconds,
                                    const SearchProgress& progress);

}  // namespace fde::bench
