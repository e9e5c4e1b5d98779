// SPDX-License-Identifier: MIT
// Mittag-Leffler functions of arbitrary doubles: a value with a bound, or a one-line error.

#include <algorithm>
#include <cmath>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fuzz/fuzzing.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

void evaluate_in_double(double alpha, double beta, std::complex<double> z) {
  const auto [value, bound] = reference::mittag_leffler(alpha, beta, z);
  const auto shown = fmt::format("E_{{{},{}}}({}, {}) = {} {} bound {}", alpha, beta, z.real(), z.imag(),
                                 value.real(), value.imag(), bound);
  fuzz::require(bound >= 0.0, "a bound is not negative", shown);
  const bool finite = std::isfinite(value.real()) && std::isfinite(value.imag());
  fuzz::require(finite == std::isfinite(bound), "a finite value has a finite bound, no other has", shown);
}

void in_digits(double alpha, double beta, std::complex<double> z, int digits) {
  const auto text = [](double number) { return fmt::format("{}", number); };
  const auto [re, im, bound] =
      reference::mittag_leffler(text(alpha), text(beta), text(z.real()), text(z.imag()), digits);
  fuzz::require(!re.empty() && !im.empty() && !bound.empty(), "all digits are there");
  const auto shown = fmt::format("{} {} {}", re, im, bound);
  fuzz::require(shown.find("nan") == std::string::npos, "digits of a number", shown);
  const bool overflows = re.find("inf") != std::string::npos || im.find("inf") != std::string::npos;
  fuzz::require(overflows == (bound == "inf"), "a value has a bound unless it is beyond all exponents",
                shown);
}

}  // namespace

FDE_FUZZ_TARGET(mittag_leffler) {
  fuzz::Bytes bytes(data, size);
  const bool digits = bytes.index_below(64) == 0;  // slower by orders of magnitude
  const auto alpha = bytes.take<double>(), beta = bytes.take<double>();
  const auto re = bytes.take<double>(), im = bytes.take<double>();
  fuzz::require_one_line_errors([&] {
    if (digits) {
      // Short texts: every digit after the point increases the working precision.
      const auto moderate = [](double number, double most) {
        return std::round(1000.0 * std::fmod(number, most)) / 1000.0;
      };
      in_digits(std::max(0.05, moderate(alpha, 5.5)), moderate(beta, 50.0),
                {moderate(re, 20.0), moderate(im, 20.0)}, 20);
    } else {
      evaluate_in_double(alpha, beta, {re, im});
    }
  });
  return 0;
}
