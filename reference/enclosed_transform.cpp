#include "enclosed_transform.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace fde {
namespace {

constexpr int guard_digits = 2;
constexpr long double largest_exponent = 7e8L;  // e^this is within mpfr's default exponents

int missing_digits(const Bounded<BigReal>& x, const BigReal& scale, int wanted, int zero_digits) {
  const BigReal size = std::max(size_of(x.value), BigReal(scale * pow(BigReal(10), -zero_digits)));
  if (x.bound == 0 || size == 0) return 0;
  return static_cast<int>(ceil(log10(BigReal(x.bound / size)))) + wanted;
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

std::vector<Bounded<BigReal>> invert(const EnclosedTransform& transform, int wanted_digits) {
  const int most = 4 * wanted_digits + 1000;  // then the bound says what there is
  for (int digits = wanted_digits + guard_digits;;) {
    const EnclosingContour contour(transform.singularities, digits, transform.hints);
    if (contour.sigma() > largest_exponent)
      throw std::runtime_error(fmt::format("e^{:.6g} is beyond all exponents", contour.sigma()));
    const Precision precision(contour.working_digits());
    const auto sums = sum_over_nodes(transform, contour);
    std::vector<BigReal> neglected;
    for (const auto& majorant : transform.majorants)
      neglected.push_back(exp(BigReal(contour.log_bound(majorant))));
    std::vector<Bounded<BigReal>> values;
    int missing = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const BigReal& off = neglected[neglected.size() == 1 ? 0 : i];
      values.push_back({sums[i].value, BigReal(off + sums[i].error)});
      missing = std::max(missing,
                         missing_digits(values.back(), sums[i].scale, wanted_digits, transform.zero_digits));
    }
    if (missing == 0 || digits >= most) return values;
    digits = std::min(digits + missing + 1, most);
  }
}

}  // namespace fde
