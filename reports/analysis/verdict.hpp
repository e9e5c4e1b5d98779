#pragma once

#include <string>
#include <string_view>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde {

// The result of a trial in a word. `survives`: the relative error of every column at the end, bound of the
// reference included, is at most 1/100. `stops rightly`: the run ended at a singularity of the solution.
struct Verdict {
  std::string_view word;

  auto operator<=>(const Verdict&) const = default;
};
inline constexpr Verdict survives{"survives"}, inaccurate{"inaccurate"}, stops{"stops rightly"},
    fails{"fails"}, refuses{"refuses"}, not_judged{"not judged"};

Verdict verdict(const MeasuredRun& run);

// A sentence that explains the verdict, with error, rounding and time if they were measured.
std::string because(const MeasuredRun& run);

}  // namespace fde
