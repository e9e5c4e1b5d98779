// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include "reports/synthetic_results.hpp"

// Synthetic results of a family of scenes.
namespace fde::bench {

// A timed run of a scheme on relaxation with these parameters.
inline void add_run_at(Results& results, const ParameterValues& values, const std::string& scheme,
                       double error, double seconds) {
  add_value(results, {"relaxation", scheme, 64}, "error_maximum_mixed", error);
  add_run(results, {"relaxation", scheme, 64}, error, seconds);
  results.records.back().key.scene.values = values;
}

// Over gamma x lambda: l1 takes 1 s everywhere; adams_pc takes 0.5 s for lambda >= -10, 4 s below, and is
// within 1e-4 where l1 is within 1e-2 only.
inline Results over_plane(int gammas, int lambdas) {
  Results results = empty_results();
  for (int i = 0; i < gammas; ++i) {
    for (int j = 0; j < lambdas; ++j) {
      const ParameterValues at{{"gamma", 0.1 * (i + 1)}, {"lambda", -std::pow(10.0, j)}};
      add_run_at(results, at, "l1", 1e-3, 1.0);
      add_run_at(results, at, "adams_pc", 1e-5, j <= 1 ? 0.5 : 4.0);
    }
  }
  return results;
}

}  // namespace fde::bench
