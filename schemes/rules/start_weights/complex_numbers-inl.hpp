// SPDX-License-Identifier: MIT
// Complex numbers whose parts are of any type, for the series of number_series-inl.hpp. Included once for
// each vector target.

#if defined(FDE_COMPLEX_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_COMPLEX_NUMBERS_INL
#undef FDE_COMPLEX_NUMBERS_INL
#else
#define FDE_COMPLEX_NUMBERS_INL
#endif

#include <hwy/highway.h>

#include <complex>
#include <cstddef>

#include "fdebench/schemes/rules/start_weights/elementary_functions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

template <class Real>
struct Complex {
  Complex(const Real& real, const Real& imaginary) : re(real), im(imaginary) {}
  explicit Complex(const Real& real) : re(real), im(0.0) {}
  explicit Complex(double real) : re(real), im(0.0) {}
  explicit Complex(std::size_t real) : re(real), im(0.0) {}
  explicit Complex(const std::complex<double>& z) : re(z.real()), im(z.imag()) {}

  Real re, im;
};

template <class Real>
Complex<Real> operator-(const Complex<Real>& a) {
  return {-a.re, -a.im};
}
template <class Real>
Complex<Real> operator+(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re + b.re, a.im + b.im};
}
template <class Real>
Complex<Real> operator-(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re - b.re, a.im - b.im};
}
template <class Real>
Complex<Real> operator*(const Complex<Real>& a, const Complex<Real>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class Real>
Complex<Real> operator*(const Complex<Real>& a, const Real& b) {
  return {a.re * b, a.im * b};
}
template <class Real>
Complex<Real> operator/(const Complex<Real>& a, const Complex<Real>& b) {
  const Real size = Real(1.0) / (b.re * b.re + b.im * b.im);
  return {(a.re * b.re + a.im * b.im) * size, (a.im * b.re - a.re * b.im) * size};
}

template <class Real>
Complex<Real> exp(const Complex<Real>& z) {
  const Real size = exp(z.re);
  const auto [sine, cosine] = sine_and_cosine(z.im);
  return {size * cosine, size * sine};
}

// The logarithm of z that is near `approximation`, by Newton's method for exp.
template <class Real>
Complex<Real> log(const Complex<Real>& z, const std::complex<double>& approximation) {
  Complex<Real> value(approximation);
  for (int step = 0; step < 3; ++step) value = value + (z * exp(-value) - Complex<Real>(1.0));
  return value;
}

template <class Real>
class SumOfProducts<Complex<Real>> {
 public:
  SumOfProducts() : re_(), im_() {}  // an implicit one is not compiled for the target
  void add(const Complex<Real>& a, const Complex<Real>& b) {
    re_.add(a.re, b.re);
    re_.add(-a.im, b.im);
    im_.add(a.re, b.im);
    im_.add(a.im, b.re);
  }
  void add(const Complex<Real>& a, const Real& b) {
    re_.add(a.re, b);
    im_.add(a.im, b);
  }
  [[nodiscard]] Complex<Real> value() const { return {re_.value(), im_.value()}; }

 private:
  SumOfProducts<Real> re_, im_;
};

template <class Real>
class Numbers<Complex<Real>> {
 public:
  explicit Numbers(std::size_t size = 0) : re_(size), im_(size) {}
  [[nodiscard]] std::size_t size() const { return re_.size(); }
  [[nodiscard]] std::complex<double> rounded(std::size_t i) const { return {re_.rounded(i), im_.rounded(i)}; }
  [[nodiscard]] Complex<Real> each(std::size_t i) const { return {re_.each(i), im_.each(i)}; }
  [[nodiscard]] Complex<Real> from(std::size_t i) const { return {re_.from(i), im_.from(i)}; }
  void put(std::size_t i, const Complex<Real>& z) {
    re_.put(i, z.re);
    im_.put(i, z.im);
  }
  void set(std::size_t i, const Complex<Real>& z) {
    re_.set(i, z.re);
    im_.set(i, z.im);
  }

 private:
  Numbers<Real> re_, im_;
};

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
