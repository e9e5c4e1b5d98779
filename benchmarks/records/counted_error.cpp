// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/counted_error.hpp"

#include <algorithm>

namespace fde::bench {

std::optional<CountedError> counted_error(const Record& run, const ErrorKind& kind) {
  const auto error = run[error_measure(kind)];
  if (!error) return std::nullopt;
  const bool at_end = kind.norm == Norm::end;
  const double absolute = run[error_measure({kind.norm, Scale::absolute})].value_or(0.0),
               bound = run[at_end ? "reference_bound" : "reference_bound_maximum"].value_or(0.0),
               unresolved = at_end ? 0.0 : run[unresolved_measure(kind.scale)].value_or(0.0);
  return CountedError{.value = std::max(*error, unresolved),
                      .reference_bound = absolute > 0.0 ? bound * (*error / absolute) : bound};
}

}  // namespace fde::bench
