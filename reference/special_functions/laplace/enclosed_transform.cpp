// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/enclosed_transform.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/bounded.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

// Largest Re s of e^s, as in exp_overflows(); above 1e9 long double is too coarse for the distances between
// the contour and the singularities. Precondition: a Precision is in force.
long double largest_exponent() { return std::min(1e9L, 0.6L * static_cast<long double>(mpfr_get_emax())); }

std::vector<BoundedSum<BigReal>> sum_over_nodes(const EnclosedTransform& transform,
                                                const EnclosingContour& contour) {
  std::vector<BoundedSum<BigReal>> sums;
  const auto add = transform.prepare();
  const auto nodes = transform.real ? contour.upper_nodes() : contour.nodes();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    report_progress(k, nodes.size());
    add(nodes[k], sums);
  }
  for (auto& sum : sums) {
    if (transform.real) {
      sum.value = BigComplex(BigReal(2 * real_part<BigReal>(sum.value)));
      sum.error *= 2;
      sum.scale *= 2;
    }
    sum.scale *= exp(BigReal(-contour.right_extent()));
    if (isfinite(norm1(sum.value))) continue;
    // The denominator of a term was computed as 0: more digits are needed.
    sum.value = BigComplex(0);
    sum.error = BigReal(std::numeric_limits<double>::infinity());
  }
  return sums;
}

std::vector<WorkingEstimate> estimates_at(const EnclosedTransform& transform, int digits) {
  const EnclosingContour contour(transform.singularities, digits, transform.hints);
  const Precision precision(contour.working_digits());
  if (contour.sigma() > largest_exponent())
    throw std::runtime_error(fmt::format("e^{:.6g} is beyond all exponents", contour.sigma()));
  const auto sums = sum_over_nodes(transform, contour);
  std::vector<BigReal> neglected;
  for (const auto& majorant : transform.majorants)
    neglected.push_back(exp(BigReal(contour.log_bound(majorant))));
  std::vector<WorkingEstimate> estimates;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const BigReal bound = neglected[neglected.size() == 1 ? 0 : i] + sums[i].error;
    // all terms are 0: a structurally zero entry
    const bool settled = sums[i].scale == 0 && isfinite(bound);
    estimates.push_back(
        {.value_and_bound = {sums[i].value, bound}, .scale = sums[i].scale, .is_final = settled});
  }
  return estimates;
}

}  // namespace

std::vector<Bounded<BigReal>> invert(const EnclosedTransform& transform, int wanted_digits) {
  // at most twice as many digits: while the bound is infinite, `missing` is of no use
  const DigitSearchOptions search{
      .target_digits = wanted_digits,
      .guard = 2,
      .next_digits = [](int digits, int missing) { return digits + std::min(missing, digits) + 1; },
      .zero_digits = transform.zero_digits};
  const Precision precision(wanted_digits + 10);
  const DigitSearchResult raised =
      increase_digits(search, [&](int digits) { return estimates_at(transform, digits); });
  if (raised.largest_missed_bound) throw insufficient_digits(raised);
  return raised.values;
}

}  // namespace fde::reference
