// SPDX-License-Identifier: MIT
#pragma once

#include <acb.h>

#include <complex>
#include <string>
#include <utility>

namespace fde::reference::certificate {

// Scope guard that sets the working precision of this thread, in bits.
class WorkingBits {
 public:
  explicit WorkingBits(long bits) : before_(std::exchange(current, bits)) {}
  ~WorkingBits() { current = before_; }
  WorkingBits(const WorkingBits&) = delete;
  WorkingBits& operator=(const WorkingBits&) = delete;
  WorkingBits(WorkingBits&&) = delete;
  WorkingBits& operator=(WorkingBits&&) = delete;
  static long get() { return current; }

 private:
  inline static thread_local long current = 128;
  long before_;
};

// A rectangle around a mid point that encloses a complex number: Arb's acb with value semantics. The result
// of every operation encloses the results for all members of its operands. A ball is real if its imaginary
// part is exactly 0.
class Ball {
 public:
  Ball() { acb_init(&x_); }
  Ball(double re) : Ball() {
    acb_set_d(&x_, re);
  }  // NOLINT(google-explicit-constructor,hicpp-explicit-conversions)
  explicit Ball(std::complex<double> z) : Ball() { acb_set_d_d(&x_, z.real(), z.imag()); }
  Ball(const Ball& other) : Ball() { acb_set(&x_, &other.x_); }
  Ball(Ball&& other) noexcept : Ball() { acb_swap(&x_, &other.x_); }
  Ball& operator=(Ball other) noexcept {
    acb_swap(&x_, &other.x_);
    return *this;
  }
  ~Ball() { acb_clear(&x_); }

  // The number with these decimal texts. Throws std::invalid_argument unless they are numbers.
  static Ball parse(const std::string& re, const std::string& im);
  static Ball pi();
  static Ball i();

  acb_ptr get() { return &x_; }
  [[nodiscard]] acb_srcptr get() const { return &x_; }
  [[nodiscard]] arb_srcptr real_part() const { return acb_realref(&x_); }
  [[nodiscard]] arb_srcptr imag_part() const { return acb_imagref(&x_); }

  [[nodiscard]] bool is_real() const { return acb_is_real(&x_) != 0; }
  [[nodiscard]] bool contains(const Ball& other) const { return acb_contains(&x_, &other.x_) != 0; }
  [[nodiscard]] bool overlaps(const Ball& other) const { return acb_overlaps(&x_, &other.x_) != 0; }
  // Correct binary digits of the mid point, relative to the modulus.
  [[nodiscard]] long accuracy() const { return acb_rel_accuracy_bits(&x_); }
  [[nodiscard]] std::complex<double> mid() const;
  // The parts as decimal texts with at most `digits` digits, only correct ones.
  [[nodiscard]] std::pair<std::string, std::string> text(int digits) const;
  // An upper bound of the real part, with 3 digits.
  [[nodiscard]] std::string upper_bound_text() const;

  // Enlarges the rectangle, in both directions, by the upper bound of |error|.
  void widen(const Ball& error);

 private:
  acb_struct x_{};
};

Ball operator+(const Ball& a, const Ball& b);
Ball operator-(const Ball& a, const Ball& b);
Ball operator*(const Ball& a, const Ball& b);
Ball operator/(const Ball& a, const Ball& b);
Ball operator-(const Ball& a);

Ball exp(const Ball& x);
Ball log(const Ball& x);  // principal
Ball sin(const Ball& x);
Ball cos(const Ball& x);
Ball erfc(const Ball& x);
Ball reciprocal_gamma(const Ball& x);
Ball power(const Ball& x, unsigned long exponent);
Ball abs(const Ball& x);
Ball arg(const Ball& x);  // in (-pi, pi]
Ball conj(const Ball& x);
Ball real(const Ball& x);
Ball imag(const Ball& x);

// Comparisons of the real parts: true if they hold for all members; false may mean "not known".
bool operator<(const Ball& a, const Ball& b);
bool operator>(const Ball& a, const Ball& b);

// Upper and lower bound of log2 |x|, for estimates; infinite where x is 0 or not finite.
double log2_upper_bound(const Ball& x);
double log2_lower_bound(const Ball& x);

}  // namespace fde::reference::certificate
