#include "numbers/raise_digits.hpp"

#include <fmt/format.h>

namespace fde {
namespace {

// Number of decimal digits by which the bound exceeds the target; 0 where the target is met.
int missing_digits(const WorkingEstimate& estimate, const DigitSearch& search, int digits) {
  if (estimate.settled) return 0;
  const auto& [value, bound] = estimate.known;
  if (!isfinite(bound)) return digits;  // a divisor was computed as 0
  if (bound == 0) return 0;
  const BigReal zero = estimate.scale * pow(BigReal(10), -search.zero_digits);
  const BigReal size = std::max(size_of(value), zero);
  if (size == 0 || !isfinite(size)) return digits;
  const BigReal missing = ceil(log10(BigReal(bound / size))) + search.wanted;
  return static_cast<int>(std::clamp(missing, BigReal(0), BigReal(most_digits(search.wanted))));
}

}  // namespace

Raised raise_digits(const DigitSearch& search,
                    const std::function<std::vector<WorkingEstimate>(int digits)>& evaluate) {
  const int most = most_digits(search.wanted);
  for (int digits = search.wanted + search.guard;;) {
    Raised raised{.values = {}, .digits = digits};
    int missing = 0;
    for (auto& estimate : evaluate(digits)) {
      const int own = missing_digits(estimate, search, digits);
      missing = std::max(missing, own);
      const BigReal& bound = estimate.known.bound;
      if (own > 0 && !(raised.too_large && bound < *raised.too_large)) raised.too_large = bound;
      raised.values.push_back(std::move(estimate.known));
    }
    if (missing == 0 || digits >= most) return raised;
    digits = std::min(search.next(digits, missing), most);
  }
}

std::runtime_error out_of_digits(const Raised& raised) {
  return std::runtime_error(fmt::format("no accurate value in reach: bound {} at {} digits",
                                        write_bound(raised.too_large.value()), raised.digits));
}

}  // namespace fde
