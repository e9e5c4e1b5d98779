// SPDX-License-Identifier: MIT
#include "certificate/ball.hpp"

#include <acb_hypgeom.h>

#include <limits>
#include <memory>
#include <stdexcept>

namespace fde::reference::certificate {
namespace {

template <class Function>
Ball new_ball(Function function) {
  Ball result;
  function(result.get());
  return result;
}

std::string to_text(arb_srcptr x, int digits) {
  const std::unique_ptr<char, decltype(&flint_free)> text(arb_get_str(x, digits, ARB_STR_NO_RADIUS),
                                                          flint_free);
  return text.get();
}

// log2 of an arf that is positive or zero.
double log2_of(arf_srcptr x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (arf_is_zero(x) != 0) return -infinity;
  if (arf_is_finite(x) == 0) return infinity;
  fmpz_t exponent;
  fmpz_init(exponent);
  arf_abs_bound_lt_2exp_fmpz(exponent, x);
  const double bits = fmpz_get_d(exponent);
  fmpz_clear(exponent);
  return bits;
}

}  // namespace

Ball Ball::parse(const std::string& re, const std::string& im) {
  Ball ball;
  if (arb_set_str(acb_realref(ball.get()), re.c_str(), WorkingBits::get()) != 0 ||
      arb_set_str(acb_imagref(ball.get()), im.c_str(), WorkingBits::get()) != 0) {
    throw std::invalid_argument("\"" + re + ", " + im + "\" is no number");
  }
  return ball;
}

Ball Ball::pi() {
  return new_ball([](acb_ptr y) { acb_const_pi(y, WorkingBits::get()); });
}

Ball Ball::i() {
  return new_ball([](acb_ptr y) { acb_onei(y); });
}

std::complex<double> Ball::mid() const {
  return {arf_get_d(arb_midref(real_part()), ARF_RND_NEAR), arf_get_d(arb_midref(imag_part()), ARF_RND_NEAR)};
}

std::pair<std::string, std::string> Ball::text(int digits) const {
  return {to_text(real_part(), digits), to_text(imag_part(), digits)};
}

std::string Ball::upper_bound_text() const {
  arf_t bound;
  arf_init(bound);
  arb_get_ubound_arf(bound, real_part(), MAG_BITS);
  const Ball rounded_up = new_ball([&](acb_ptr y) {
    arb_set_arf(acb_realref(y), bound);
    arb_mul_ui(acb_realref(y), acb_realref(y), 101, MAG_BITS);
    arb_div_ui(acb_realref(y), acb_realref(y), 100, MAG_BITS);
  });
  arf_clear(bound);
  return to_text(rounded_up.real_part(), 3);
}

void Ball::widen(const Ball& error) {
  mag_t bound;
  mag_init(bound);
  acb_get_mag(bound, error.get());
  acb_add_error_mag(&x_, bound);
  mag_clear(bound);
}

Ball operator+(const Ball& a, const Ball& b) {
  return new_ball([&](acb_ptr y) { acb_add(y, a.get(), b.get(), WorkingBits::get()); });
}
Ball operator-(const Ball& a, const Ball& b) {
  return new_ball([&](acb_ptr y) { acb_sub(y, a.get(), b.get(), WorkingBits::get()); });
}
Ball operator*(const Ball& a, const Ball& b) {
  return new_ball([&](acb_ptr y) { acb_mul(y, a.get(), b.get(), WorkingBits::get()); });
}
Ball operator/(const Ball& a, const Ball& b) {
  return new_ball([&](acb_ptr y) { acb_div(y, a.get(), b.get(), WorkingBits::get()); });
}
Ball operator-(const Ball& a) {
  return new_ball([&](acb_ptr y) { acb_neg(y, a.get()); });
}

Ball exp(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_exp(y, x.get(), WorkingBits::get()); });
}
Ball log(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_log(y, x.get(), WorkingBits::get()); });
}
Ball sin(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_sin(y, x.get(), WorkingBits::get()); });
}
Ball cos(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_cos(y, x.get(), WorkingBits::get()); });
}
Ball erfc(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_hypgeom_erfc(y, x.get(), WorkingBits::get()); });
}
Ball reciprocal_gamma(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_rgamma(y, x.get(), WorkingBits::get()); });
}
Ball power(const Ball& x, unsigned long exponent) {
  return new_ball([&](acb_ptr y) { acb_pow_ui(y, x.get(), exponent, WorkingBits::get()); });
}
Ball abs(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_abs(acb_realref(y), x.get(), WorkingBits::get()); });
}
Ball arg(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_arg(acb_realref(y), x.get(), WorkingBits::get()); });
}
Ball conj(const Ball& x) {
  return new_ball([&](acb_ptr y) { acb_conj(y, x.get()); });
}
Ball real(const Ball& x) {
  return new_ball([&](acb_ptr y) { arb_set(acb_realref(y), x.real_part()); });
}
Ball imag(const Ball& x) {
  return new_ball([&](acb_ptr y) { arb_set(acb_realref(y), x.imag_part()); });
}

bool operator<(const Ball& a, const Ball& b) { return arb_lt(a.real_part(), b.real_part()) != 0; }
bool operator>(const Ball& a, const Ball& b) { return arb_gt(a.real_part(), b.real_part()) != 0; }

double log2_upper_bound(const Ball& x) {
  arf_t bound;
  arf_init(bound);
  acb_get_abs_ubound_arf(bound, x.get(), 30);
  const double bits = log2_of(bound);
  arf_clear(bound);
  return bits;
}

double log2_lower_bound(const Ball& x) {
  arf_t bound;
  arf_init(bound);
  acb_get_abs_lbound_arf(bound, x.get(), 30);
  const double bits = log2_of(bound) - 1.0;
  arf_clear(bound);
  return bits;
}

}  // namespace fde::reference::certificate
