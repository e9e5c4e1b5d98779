// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_shape.hpp"

#include "fdebench/reference/special_functions/laplace/sheets.hpp"
#include "fdebench/reference/special_functions/numbers/constants.hpp"

namespace fde::reference {
namespace {

using Long = long double;
using Point = PrabhakarSingularities::Point;
using Disc = EnclosingContour::Disc;

constexpr Long hair = 1e-9L;  // an upper bound of all rounding errors in the majorants

// Logarithm of a bound of |s|^power on a disc.
Long log_power(const Disc& disc, Long power) {
  const Long size = std::abs(disc.centre);
  if (power >= 0.0L) return power == 0.0L ? 0.0L : power * std::log(size + disc.radius);
  return size > disc.radius ? power * std::log(size - disc.radius) : infinity_long;
}

// For integer alpha: F = s^(alpha gamma - beta) product of (s - s*)^-gamma.
Long majorant_by_roots(const PrabhakarSingularities& x, const Disc& disc) {
  Long sum = log_power(disc, (x.alpha * x.gamma - x.beta));
  for (const auto& root : x.roots) sum += log_power({disc.centre - root, disc.radius}, -x.gamma);
  return sum + hair;
}

// With u = alpha log s - log z, 1 - z s^-alpha = 1 - e^-u; uses the one of 1 - e^-u and e^u - 1 that is not
// large.
Long majorant_by_logarithm(const PrabhakarSingularities& x, const Disc& disc) {
  const Long size = std::abs(disc.centre);
  if (disc.radius >= 0.5L * size) return infinity_long;
  const Long spread = -x.alpha * std::log1p(-disc.radius / size);  // of u on the disc
  const Point u = x.alpha * std::log(disc.centre) - x.log_z;
  const bool far = u.real() >= 0.0L;
  const Point exponential = std::exp(far ? -u : u);
  const Long centre = std::abs(1.0L - exponential), off = std::abs(exponential) * std::expm1(spread);
  const Long least = centre * (1.0L - hair) - off;
  if (x.gamma > 0.0L && least <= hair * centre + hair * hair) return infinity_long;
  const Long other = far ? 0.0L : x.gamma * (u.real() + (x.gamma > 0.0L ? spread : -spread));
  const Long log_factor = -x.gamma * std::log(x.gamma > 0.0L ? least : centre + off);
  return log_power(disc, -x.beta) + log_factor + other + hair * (1.0L + std::abs(x.gamma));
}

// For F without the term (-z)^-gamma s^power: |(1 - x)^-gamma - 1| <= e^(|gamma| |x| / (1 - |x|)) - 1,
// x = s^alpha / z.
Long majorant_without_head(const PrabhakarSingularities& x, const Disc& disc) {
  const Long log_ratio = log_power(disc, x.alpha) - x.log_z.real();
  if (log_ratio > std::log(0.5L)) return infinity_long;
  const Long ratio = std::exp(log_ratio), exponent = std::abs(x.gamma) * ratio / (1.0L - ratio);
  // (e^y - 1) / y <= e^y
  const Long log_factor = log_ratio + std::log(std::abs(x.gamma) / (1.0L - ratio)) + exponent;
  return log_power(disc, (x.alpha * x.gamma - x.beta)) - x.gamma * x.log_z.real() + log_factor +
         hair * (1.0L + std::abs(x.gamma * x.log_z.real()));
}

}  // namespace

PrabhakarSingularities::PrabhakarSingularities(const PrabhakarArguments& x)
    : alpha(x.alpha.convert_to<Long>()),
      beta(x.beta.convert_to<Long>()),
      gamma(x.gamma.convert_to<Long>()),
      integer_alpha(is_integer(x.alpha)) {
  const BigComplex logarithm = log(x.z);
  log_z = {real_part<BigReal>(logarithm).convert_to<Long>(),
           imag_part<BigReal>(logarithm).convert_to<Long>()};
  const BigReal power = x.alpha * x.gamma - x.beta, nearest = round(power);
  integer_power = nearest >= 0 && abs(BigReal(power - nearest)) < pow(BigReal(10), -100);
  for (const auto& root : roots_on_sheet(alpha, log_z)) {
    log_roots.push_back(root.logarithm);
    roots.push_back(root.value);
  }
}

BigReal PrabhakarSingularities::power_of(const PrabhakarArguments& x) const {
  const BigReal power = x.alpha * x.gamma - x.beta;
  return integer_power ? BigReal(round(power)) : power;
}

bool PrabhakarSingularities::subtracts_leading_term() const {
  constexpr Long far = -1e6L;
  const auto is_far = [](const Point& s) { return s.real() < far; };
  return integer_power && !integer_alpha && std::log(-far) * alpha < log_z.real() &&
         std::ranges::all_of(roots, is_far);
}

long double PrabhakarSingularities::log_majorant(const Disc& disc) const {
  if (integer_alpha) return majorant_by_roots(*this, disc);
  return subtracts_leading_term() ? majorant_without_head(*this, disc) : majorant_by_logarithm(*this, disc);
}

}  // namespace fde::reference
