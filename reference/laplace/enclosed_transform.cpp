#include "laplace/enclosed_transform.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "numbers/bounded.hpp"

namespace fde {
namespace {

constexpr int guard_digits = 2;

// Of e^s, as exp_overflows() has it; and beyond 1e9 long double is too coarse for the distances between the
// contour and its singularities. Call under a Precision.
long double largest_exponent() { return std::min(1e9L, 0.6L * static_cast<long double>(mpfr_get_emax())); }

// How many decimal digits the bound is above the target, at most as many as there are: all of them where
// there is no bound.
int missing_digits(const Bounded<BigReal>& x, const BigReal& scale, int wanted, int zero_digits, int digits) {
  if (!isfinite(x.bound)) return digits;
  const BigReal size = std::max(size_of(x.value), BigReal(scale * pow(BigReal(10), -zero_digits)));
  // nothing but zeros was summed: an entry that vanishes by structure, as good as those it is among
  if (x.bound == 0 || size == 0) return 0;
  if (!isfinite(size)) return digits;
  const BigReal missing = ceil(log10(BigReal(x.bound / size))) + wanted;
  return static_cast<int>(std::clamp(missing, BigReal(0), BigReal(digits)));
}

std::vector<Sum<BigReal>> sum_over_nodes(const EnclosedTransform& transform,
                                         const EnclosingContour& contour) {
  std::vector<Sum<BigReal>> sums;
  const auto add = transform.prepare();
  for (const auto& node : transform.real ? contour.upper_nodes() : contour.nodes()) add(node, sums);
  for (auto& sum : sums) {
    if (transform.real) {
      sum.value = BigComplex(BigReal(2 * real_part<BigReal>(sum.value)));
      sum.error *= 2;
      sum.scale *= 2;
    }
    sum.scale *= exp(BigReal(-contour.rise()));
    if (!isfinite(size_of(sum.value))) throw std::runtime_error("enclosed transform: a sum is not finite");
  }
  return sums;
}

}  // namespace

std::runtime_error out_of_digits(const BigReal& bound, int digits) {
  return std::runtime_error(
      fmt::format("no accurate value in reach: bound {} at {} digits", write_bound(bound), digits));
}

std::vector<Bounded<BigReal>> invert(const EnclosedTransform& transform, int wanted_digits) {
  const int most = 4 * wanted_digits + 1000;
  for (int digits = wanted_digits + guard_digits;;) {
    const EnclosingContour contour(transform.singularities, digits, transform.hints);
    const Precision precision(contour.working_digits());
    if (contour.sigma() > largest_exponent())
      throw std::runtime_error(fmt::format("e^{:.6g} is beyond all exponents", contour.sigma()));
    const auto sums = sum_over_nodes(transform, contour);
    std::vector<BigReal> neglected;
    for (const auto& majorant : transform.majorants)
      neglected.push_back(exp(BigReal(contour.log_bound(majorant))));
    std::vector<Bounded<BigReal>> values;
    int missing = 0;
    BigReal worst(0);  // of the bounds that are too large
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const BigReal& off = neglected[neglected.size() == 1 ? 0 : i];
      values.push_back({sums[i].value, BigReal(off + sums[i].error)});
      const int own =
          missing_digits(values.back(), sums[i].scale, wanted_digits, transform.zero_digits, digits);
      missing = std::max(missing, own);
      if (own > 0 && !(values.back().bound < worst)) worst = values.back().bound;
    }
    if (missing == 0) return values;
    if (digits >= most) throw out_of_digits(worst, digits);
    digits = std::min(digits + missing + 1, most);
  }
}

}  // namespace fde
