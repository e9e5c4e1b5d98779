#pragma once

#include <string>
#include <string_view>

#include "analysis/runs.hpp"

namespace fde {

// What the page says of a trial in a word. A run survives when every value at the end is within a hundredth
// of its size of the reference, the bound of the reference included; it stops where the solution has a
// singularity.
struct Verdict {
  std::string_view word;

  auto operator<=>(const Verdict&) const = default;
};
inline constexpr Verdict survives{"survives"}, inaccurate{"inaccurate"}, stops{"stops rightly"},
    fails{"fails"}, refuses{"refuses"}, not_judged{"not judged"};

Verdict verdict(const MeasuredRun& run);

// The sentence that says why, with error, rounding and time where they were measured.
std::string because(const MeasuredRun& run);

}  // namespace fde
