// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

#include <algorithm>
#include <cstring>

#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

using namespace fde::bench::c;

int fdebench_mittag_leffler(double alpha, double beta, double re, double im, double value[2], double* bound) {
  return guarded([&] {
    given("value", value);
    auto& error = given("bound", bound);
    const auto result = fde::reference::mittag_leffler(alpha, beta, std::complex<double>(re, im));
    value[0] = result.value.real();
    value[1] = result.value.imag();
    error = result.bound;
  });
}

int fdebench_mittag_leffler_digits(const char* alpha, const char* beta, const char* re, const char* im,
                                   int digits, char* value_re, char* value_im, char* bound, size_t capacity) {
  return guarded([&] {
    given("value_re", value_re);
    given("value_im", value_im);
    given("bound", bound);
    constexpr int exponents = 32;  // and signs, points and the final 0
    require_capacity(capacity, static_cast<std::size_t>(std::max(digits, 0)) + exponents);
    const auto result = fde::reference::mittag_leffler(text_of("alpha", alpha), text_of("beta", beta),
                                                       text_of("re", re), text_of("im", im), digits);
    std::memcpy(value_re, result.re.c_str(), result.re.size() + 1);
    std::memcpy(value_im, result.im.c_str(), result.im.size() + 1);
    std::memcpy(bound, result.bound.c_str(), result.bound.size() + 1);
  });
}
