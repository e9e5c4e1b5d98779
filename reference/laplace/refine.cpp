#include "laplace/refine.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "laplace/contour.hpp"
#include "numbers/bounded.hpp"

namespace fde {
namespace {

constexpr int guard_digits = 8;
constexpr int zero_digits = 40;

// At so many digits the bound says what there is.
int most_digits(int wanted_digits) { return 4 * wanted_digits + 1000; }

std::vector<Sum<BigReal>> evaluate_at(const EvaluateAt& evaluate, int digits, int extra) {
  const Precision precision(contour_precision(digits) + extra);
  return evaluate(digits);
}

// How many decimal digits the bound is above the target; not positive where it is met.
int missing_digits(const Bounded<BigReal>& x, const BigReal& scale, int wanted, int digits) {
  if (!isfinite(x.bound)) return digits;  // a difference came out as 0 and was divided by
  if (x.bound == 0) return 0;
  const BigReal size = std::max(size_of(x.value), BigReal(scale * pow(BigReal(10), -zero_digits)));
  if (size == 0) return digits;
  return static_cast<int>(ceil(log10(BigReal(x.bound / size)))) + wanted;
}

}  // namespace

std::vector<Bounded<BigReal>> refine(int wanted_digits, int extra, const EvaluateAt& evaluate) {
  const int most = most_digits(wanted_digits);
  for (int digits = wanted_digits + guard_digits;;) {
    const auto coarse = evaluate_at(evaluate, digits, extra);
    const auto fine = evaluate_at(evaluate, digits + std::max(10, digits / 16), extra);
    std::vector<Bounded<BigReal>> values;
    int missing = 0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const BigComplex difference = fine[i].value - coarse[i].value;
      values.push_back({fine[i].value, BigReal(4 * size_of(difference) + fine[i].error)});
      if (fine[i].infinite) continue;
      missing = std::max(missing, missing_digits(values.back(), fine[i].scale, wanted_digits, digits));
    }
    if (missing == 0 || digits >= most) return values;
    digits = std::min(digits + missing + 2, most);
  }
}

Bounded<BigReal> raise_digits(int wanted_digits, int extra,
                              const std::function<Sum<BigReal>(int digits)>& evaluate) {
  const int most = most_digits(wanted_digits);
  for (int digits = wanted_digits + guard_digits;;) {
    const Precision precision(contour_precision(digits) + extra);
    const Sum<BigReal> sum = evaluate(digits);
    Bounded<BigReal> value{sum.value, sum.error};
    const int missing = sum.infinite ? 0 : missing_digits(value, BigReal(0), wanted_digits, digits);
    if (missing <= 0) return value;
    if (digits >= most) throw std::runtime_error(fmt::format("no accurate value within {} digits", most));
    digits = std::min(digits + missing + 2, most);
  }
}

}  // namespace fde
