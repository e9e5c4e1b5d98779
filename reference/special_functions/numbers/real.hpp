// SPDX-License-Identifier: MIT
#pragma once

// The two number types of the references: long double, and mpfr/mpc at a precision chosen at run time.

#include <algorithm>
#include <atomic>
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <mutex>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

namespace fde::reference {

using BigReal = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                              boost::multiprecision::et_off>;
using BigComplex = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<0>,
                                                 boost::multiprecision::et_off>;

template <class Real>
using Complex = std::conditional_t<std::is_same_v<Real, BigReal>, BigComplex, std::complex<Real>>;

// Scope guard that sets the decimal digits of newly constructed BigReal and BigComplex. Boost stores that
// number once for all threads, so the guard also holds a lock: only one thread at a time computes with them.
class Precision {
 public:
  explicit Precision(int digits);
  ~Precision();
  Precision& operator=(Precision&&) = delete;

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  unsigned before_;
};

// A table computed at its first use, under Precision(digits). The lock of Precision is taken before the guard
// of the static variable, so that two threads cannot deadlock on the two.
template <int digits, auto make>
const auto& lazy_table() {
  using Table = decltype(make());
  static std::atomic<const Table*> known = nullptr;
  if (const Table* table = known.load(std::memory_order_acquire)) return *table;
  const Precision precision(digits);
  static const Table table = make();
  known.store(&table, std::memory_order_release);
  return table;
}

// Distance from 1 to the next number.
template <class Real>
Real epsilon() {
  if constexpr (std::is_same_v<Real, BigReal>) {
    return ldexp(BigReal(1), 1 - static_cast<int>(mpfr_get_prec(BigReal().backend().data())));
  } else {
    return std::numeric_limits<Real>::epsilon();
  }
}

template <class Real>
Real pi() {
  if constexpr (std::is_same_v<Real, BigReal>) {
    BigReal value;
    mpfr_const_pi(value.backend().data(), MPFR_RNDN);
    return value;
  } else {
    return std::numbers::pi_v<Real>;
  }
}

template <class Real>
Real gamma(const Real& x) {
  if constexpr (std::is_same_v<Real, BigReal>) {
    BigReal value;
    mpfr_gamma(value.backend().data(), x.backend().data(), MPFR_RNDN);
    return value;
  } else {
    return std::tgamma(x);
  }
}

inline BigReal erf(const BigReal& x) {
  BigReal value;
  mpfr_erf(value.backend().data(), x.backend().data(), MPFR_RNDN);
  return value;
}
inline BigReal erfc(const BigReal& x) {
  BigReal value;
  mpfr_erfc(value.backend().data(), x.backend().data(), MPFR_RNDN);
  return value;
}

template <class Real>
bool is_integer(const Real& x) {
  using std::floor;
  return floor(x) == x;
}

// 1/Gamma, entire: 0 at 0, -1, -2, ...
template <class Real>
Real reciprocal_gamma(const Real& x) {
  return x <= 0 && is_integer(x) ? Real(0) : Real(1) / gamma(x);
}

// |Re z| + |Im z|, in [|z|, sqrt(2) |z|]: replaces the modulus in error bounds, and is much cheaper.
template <class Real>
Real norm1(const std::complex<Real>& z) {
  return std::abs(z.real()) + std::abs(z.imag());
}
inline BigReal norm1(const BigComplex& z) { return abs(BigReal(z.real())) + abs(BigReal(z.imag())); }

template <class Real>
Real real_part(const Complex<Real>& z) {
  return Real(z.real());
}
template <class Real>
Real imag_part(const Complex<Real>& z) {
  return Real(z.imag());
}

// The decimal number in text, rounded once. Throws std::invalid_argument unless text is a finite number.
template <class Real>
Real parse(const std::string& text);
template <>
long double parse<long double>(const std::string& text);
template <>
BigReal parse<BigReal>(const std::string& text);

// x in decimal with at most `digits` significant digits, as %g of printf writes it.
std::string to_text(const BigReal& x, int digits);
// The same by a format of mpfr_snprintf that takes a precision.
std::string to_text(const BigReal& x, const char* format, int precision);

// The shortest decimal that rounds to x, as a Real: 0.1 becomes one tenth.
template <class Real>
Real from_shortest_decimal(double x);

// A sum of complex terms, a bound of its rounding error, and its scale: the sum of the sizes of the terms
// (without the factor e^mu by which the terms on a contour exceed their contribution to the value).
template <class Real>
struct BoundedSum {
  Complex<Real> value = Complex<Real>(0);
  Real error = Real(0);
  Real scale = Real(0);
  bool overflows = false;  // the sum certainly overflows
  Real largest_exponent = Real(0);

  // relative_error is relative to size: the size of the term, or a larger one if the term comes from
  // cancellation. share times size is added to the scale.
  void add(const Complex<Real>& term, const Real& relative_error, const Real& share = Real(1)) {
    add(term, norm1(term), relative_error, share);
  }
  void add(const Complex<Real>& term, const Real& size, const Real& relative_error, const Real& share) {
    if (!overflows) value += term;
    error += size * relative_error;
    scale += size * share;
  }
  void add(const BoundedSum& other) {
    error += other.error;
    scale += other.scale;
    if (other.overflows) {
      add_infinite(other.value, other.largest_exponent);
    } else if (!overflows) {
      value += other.value;
    }
  }
  // Adds direction * e^exponent, which overflows. Only the terms with the largest exponent count.
  void add_infinite(const Complex<Real>& direction, const Real& exponent) {
    constexpr double same = 1.0 + 1e-9;
    const auto part = [](const Real& x) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      return Real(x == 0 ? 0.0 : x < 0 ? -infinity : infinity);
    };
    if (overflows && exponent * same < largest_exponent) return;
    if (!overflows || exponent > same * largest_exponent) value = Complex<Real>(0);
    value += Complex<Real>(part(real_part<Real>(direction)), part(imag_part<Real>(direction)));
    overflows = true;
    largest_exponent = exponent;
  }
};

// Whether e^z certainly overflows in Real and its argument is known, for a z with that relative error.
template <class Real>
bool exp_overflows(const Complex<Real>& z, const Real& relative_error) {
  const Real error = norm1(z) * relative_error;
  // Below the largest exponent, since e^z is multiplied by factors.
  const double most = std::is_same_v<Real, BigReal> ? 0.6 * static_cast<double>(mpfr_get_emax()) : 11000.0;
  return real_part<Real>(z) - error > most && (imag_part<Real>(z) == 0 || error < 0.1);
}

}  // namespace fde::reference
