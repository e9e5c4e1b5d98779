// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The result of a trial in a word. `survives`: the relative error of every column at the end, bound of the
// reference included, is at most 1/100. `stops rightly`: the run ended at a singularity of the solution.
struct TrialResult {
  std::string_view word;

  auto operator<=>(const TrialResult&) const = default;
};
inline constexpr TrialResult survives{"survives"}, inaccurate{"inaccurate"}, stops{"stops rightly"},
    fails{"fails"}, refuses{"refuses"}, not_judged{"not judged"};

TrialResult trial_result(const Record& run);

}  // namespace fde::bench
