// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/numbers/adaptive_precision.hpp"

#include <fmt/format.h>

namespace fde::reference {
namespace {

// Number of decimal digits by which the bound exceeds the target; 0 where the target is met.
int missing_digits(const WorkingEstimate& estimate, const DigitSearchOptions& search, int digits) {
  if (estimate.is_final) return 0;
  const auto& [value, bound] = estimate.value_and_bound;
  if (!isfinite(bound)) return digits;  // a divisor was computed as 0
  if (bound == 0) return 0;
  const BigReal zero = estimate.scale * pow(BigReal(10), -search.zero_digits);
  const BigReal size = std::max(norm1(value), zero);
  if (size == 0 || !isfinite(size)) return digits;
  const BigReal missing = ceil(log10(BigReal(bound / size))) + search.target_digits;
  return static_cast<int>(std::clamp(missing, BigReal(0), BigReal(max_working_digits(search.target_digits))));
}

}  // namespace

DigitSearchResult increase_digits(const DigitSearchOptions& search,
                                  const std::function<std::vector<WorkingEstimate>(int digits)>& evaluate) {
  const int most = max_working_digits(search.target_digits);
  for (int digits = search.target_digits + search.guard;;) {
    DigitSearchResult raised{.values = {}, .digits = digits};
    int missing = 0;
    for (auto& estimate : evaluate(digits)) {
      const int own = missing_digits(estimate, search, digits);
      missing = std::max(missing, own);
      const BigReal& bound = estimate.value_and_bound.bound;
      if (own > 0 && !(raised.largest_missed_bound && bound < *raised.largest_missed_bound))
        raised.largest_missed_bound = bound;
      raised.values.push_back(std::move(estimate.value_and_bound));
    }
    if (missing == 0 || digits >= most) return raised;
    digits = std::min(search.next_digits(digits, missing), most);
  }
}

std::runtime_error insufficient_digits(const DigitSearchResult& raised) {
  return std::runtime_error(fmt::format("no accurate value in reach: bound {} at {} digits",
                                        to_bound_text(raised.largest_missed_bound.value()), raised.digits));
}

}  // namespace fde::reference
