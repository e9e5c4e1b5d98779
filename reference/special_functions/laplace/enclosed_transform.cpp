// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/enclosed_transform.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/separate_contours.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

using Sums = EnclosedTransform::Sums;

// Largest Re s of e^s, as in exp_overflows(); above 1e9 long double is too coarse for the distances between
// the contour and the singularities. Precondition: a Precision is in force.
long double largest_exponent() { return std::min(1e9L, 0.6L * static_cast<long double>(mpfr_get_emax())); }

// Contours whose sums, or their real parts twice if the transform is real, add up to the inverse transform.
std::vector<EnclosingContour> contours_for(const EnclosedTransform& transform, int digits) {
  auto contours = separate_contours(transform.singularities, digits, transform.hints);
  if (transform.real) {
    // the upper one of each conjugate pair, and the one that crosses the real axis
    std::erase_if(contours, [](const EnclosingContour& x) { return x.height() + x.half_width() < 0.0L; });
  }
  return contours;
}

Sums sum_over_nodes(const EnclosedTransform& transform, const EnclosedTransform::Evaluation& evaluation,
                    const EnclosingContour& contour) {
  Sums sums;
  const bool half = transform.real && contour.height() - contour.half_width() < 0.0L;
  const auto nodes = half ? contour.upper_nodes() : contour.nodes();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    report_progress(k, nodes.size());
    evaluation.add(nodes[k], sums);
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

// The largest number of working digits that a contour takes.
int working_digits(const EnclosedTransform& transform, const std::vector<EnclosingContour>& contours) {
  int most = 0;
  for (const EnclosingContour& contour : contours) {
    if (contour.sigma() > largest_exponent())
      throw std::runtime_error(fmt::format("e^{:.6g} is beyond all exponents", contour.sigma()));
    most = std::max(most, contour.working_digits() + transform.lost_digits(contour));
  }
  return most;
}

std::vector<WorkingEstimate> estimates_at(const EnclosedTransform& transform, int digits) {
  const auto contours = contours_for(transform, digits);
  const Precision precision(working_digits(transform, contours));
  const auto evaluation = transform.prepare();
  Sums sums;
  std::vector<BigReal> neglected(transform.majorants.size());
  for (const EnclosingContour& contour : contours) {
    const Sums own = sum_over_nodes(transform, evaluation, contour);
    sums.resize(own.size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].add(own[i]);
    const bool pair = transform.real && contour.height() - contour.half_width() > 0.0L;
    for (std::size_t i = 0; i < neglected.size(); ++i)
      neglected[i] += (pair ? 2 : 1) * exp(BigReal(contour.log_bound(transform.majorants[i])));
  }
  sums = evaluation.finish(sums);
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

void keep_right_of_saddle_point(EnclosedTransform& transform, long double beta) {
  constexpr long double large = 30.0L;
  if (beta > large) transform.singularities.emplace_back(beta / 2.0L);
}

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
