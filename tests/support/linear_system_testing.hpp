// SPDX-License-Identifier: MIT
#pragma once

// Reference solutions compared at 40 digits: most of these tests are identities between them.

#include <gtest/gtest.h>

#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::bench {

inline constexpr int tested_digits = 40;

// Sets the precision for the functions below; call it once in each test.
inline reference::Precision test_precision() { return reference::Precision(tested_digits + 30); }

inline std::vector<reference::BigReal> digits_at(const reference::Reference& solution, double t) {
  std::vector<reference::BigReal> values;
  for (const auto& [value, bound] : solution.digits(t, tested_digits)) values.emplace_back(value);
  return values;
}

// E_{alpha,beta}(re + i im) of decimals.
inline reference::BigComplex mittag_leffler_digits(const std::string& alpha, const std::string& beta,
                                                   const std::string& re, const std::string& im = "0") {
  const auto value = reference::mittag_leffler(alpha, beta, re, im, tested_digits + 5);
  return {reference::BigReal(value.re), reference::BigReal(value.im)};
}

// Equal to about 38 digits, relative to the exact value or to `size` if that is larger.
inline void expect_equal(const reference::BigReal& value, const reference::BigReal& exact,
                         const std::string& what, const reference::BigReal& size = reference::BigReal(0)) {
  const reference::BigReal scale = std::max(reference::BigReal(abs(exact)), size);
  EXPECT_LE(abs(reference::BigReal(value - exact)), scale * pow(reference::BigReal(10), 2 - tested_digits))
      << what << ": " << value.str(45) << " for " << exact.str(45);
}

}  // namespace fde::bench
