// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>

#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"

namespace fde::bench {

// A scene with a kind of error and an accuracy, as a test parameter.
struct SearchCase {
  const char* scene;
  ErrorKind kind;
  double accuracy;
};
inline std::ostream& operator<<(std::ostream& out, const SearchCase& asked) {
  return out << asked.scene << " " << error_measure(asked.kind) << " " << asked.accuracy;
}

// The target over all columns.
inline AccuracyTarget target_of(const Scene& scene, const SearchCase& asked) {
  return {asked.kind, asked.accuracy, all_columns(scene)};
}

}  // namespace fde::bench
