// SPDX-License-Identifier: MIT
// Vectors of double-doubles (unevaluated sums hi + lo, relative error about 2^-104; Dekker, Numer. Math. 18,
// 1971; Hida, Li & Bailey 2001), and their exponential, sine and cosine. Included once for each vector
// target.

#if defined(FDE_DOUBLE_DOUBLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_DOUBLE_DOUBLE_INL
#undef FDE_DOUBLE_DOUBLE_INL
#else
#define FDE_DOUBLE_DOUBLE_INL
#endif

#include <hwy/highway.h>

#include "fdebench/reference/special_functions/numbers/double_double.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::reference::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, double_double_lanes>;
using Vector = hn::Vec<Tag>;
constexpr Tag tag;

struct Real {
  Vector hi, lo;
};
struct ComplexVector {
  Real re, im;
};

HWY_INLINE Vector constant(double x) { return hn::Set(tag, x); }
HWY_INLINE Real constant(const DoubleDouble& x) { return {constant(x.hi), constant(x.lo)}; }

// Precondition: |a| >= |b|, or a = 0.
HWY_INLINE Real quick_two_sum(Vector a, Vector b) {
  const Vector sum = hn::Add(a, b);
  return {sum, hn::Sub(b, hn::Sub(sum, a))};
}

HWY_INLINE Real two_sum(Vector a, Vector b) {
  const Vector sum = hn::Add(a, b), added = hn::Sub(sum, a);
  return {sum, hn::Add(hn::Sub(a, hn::Sub(sum, added)), hn::Sub(b, added))};
}

#if !HWY_NATIVE_FMA
HWY_INLINE Vector leading_half(Vector x) {
  const Vector t = hn::Mul(constant(134217729.0), x);  // 2^27 + 1
  return hn::Sub(t, hn::Sub(t, x));
}
#endif

HWY_INLINE Real two_product(Vector a, Vector b) {
  const Vector product = hn::Mul(a, b);
#if HWY_NATIVE_FMA
  return {product, hn::MulSub(a, b, product)};
#else
  const Vector a_hi = leading_half(a), b_hi = leading_half(b), a_lo = hn::Sub(a, a_hi),
               b_lo = hn::Sub(b, b_hi);
  const Vector rest =
      hn::Add(hn::Sub(hn::Mul(a_hi, b_hi), product), hn::Add(hn::Mul(a_hi, b_lo), hn::Mul(a_lo, b_hi)));
  return {product, hn::Add(rest, hn::Mul(a_lo, b_lo))};
#endif
}

HWY_INLINE Real operator-(const Real& a) { return {hn::Neg(a.hi), hn::Neg(a.lo)}; }

HWY_INLINE Real operator+(const Real& a, const Real& b) {
  const Real high = two_sum(a.hi, b.hi), low = two_sum(a.lo, b.lo);
  const Real sum = quick_two_sum(high.hi, hn::Add(high.lo, low.hi));
  return quick_two_sum(sum.hi, hn::Add(sum.lo, low.lo));
}
HWY_INLINE Real operator-(const Real& a, const Real& b) { return a + -b; }

HWY_INLINE Real operator+(const Real& a, Vector b) {
  const Real high = two_sum(a.hi, b);
  return quick_two_sum(high.hi, hn::Add(high.lo, a.lo));
}

HWY_INLINE Real operator*(const Real& a, const Real& b) {
  const Real product = two_product(a.hi, b.hi);
  return quick_two_sum(product.hi, hn::Add(product.lo, hn::MulAdd(a.hi, b.lo, hn::Mul(a.lo, b.hi))));
}
HWY_INLINE Real operator*(const Real& a, Vector b) {
  const Real product = two_product(a.hi, b);
  return quick_two_sum(product.hi, hn::MulAdd(a.lo, b, product.lo));
}

// a b + c d with one normalisation.
HWY_INLINE Real sum_of_products(const Real& a, const Real& b, const Real& c, const Real& d) {
  const Real first = two_product(a.hi, b.hi), second = two_product(c.hi, d.hi);
  const Real sum = two_sum(first.hi, second.hi);
  const Vector first_lo = hn::Add(first.lo, hn::MulAdd(a.hi, b.lo, hn::Mul(a.lo, b.hi)));
  const Vector second_lo = hn::Add(second.lo, hn::MulAdd(c.hi, d.lo, hn::Mul(c.lo, d.hi)));
  return quick_two_sum(sum.hi, hn::Add(sum.lo, hn::Add(first_lo, second_lo)));
}

// 1 / a by one Newton step.
HWY_INLINE Real reciprocal(const Real& a) {
  const Vector one = constant(1.0), first = hn::Div(one, a.hi);
  const Real product = two_product(first, a.hi);
  const Vector rest = hn::Sub(hn::Sub(hn::Sub(one, product.hi), product.lo), hn::Mul(first, a.lo));
  return quick_two_sum(first, hn::Mul(first, rest));
}

HWY_INLINE ComplexVector operator+(const ComplexVector& a, const ComplexVector& b) {
  return {a.re + b.re, a.im + b.im};
}
HWY_INLINE ComplexVector operator*(const ComplexVector& a, const ComplexVector& b) {
  return {sum_of_products(a.re, b.re, -a.im, b.im), sum_of_products(a.re, b.im, a.im, b.re)};
}
HWY_INLINE ComplexVector operator*(const ComplexVector& a, const Real& b) { return {a.re * b, a.im * b}; }
HWY_INLINE ComplexVector operator*(const ComplexVector& a, Vector b) { return {a.re * b, a.im * b}; }

// |Re| + |Im| of the leading parts.
HWY_INLINE Vector norm1(const ComplexVector& a) { return hn::Add(hn::Abs(a.re.hi), hn::Abs(a.im.hi)); }

// x times a power of two. Precondition: no overflow or underflow.
HWY_INLINE Real scale(const Real& x, Vector power_of_two) {
  return {hn::Mul(x.hi, power_of_two), hn::Mul(x.lo, power_of_two)};
}

// The integer nearest to x, as a double and in the low bits of a word. Precondition: |x| < 2^50.
struct Rounded {
  Vector value;
  hn::Vec<hn::RebindToSigned<Tag>> bits;
};
HWY_INLINE Rounded round(Vector x) {
  const hn::RebindToSigned<Tag> integers;
  const Vector magic = constant(6755399441055744.0);  // 1.5 * 2^52: the sum has unit spacing
  const Vector shifted = hn::Add(x, magic);
  return {hn::Sub(shifted, magic), hn::BitCast(integers, shifted)};
}

// 2^n for integers -1022 <= n <= 1023.
HWY_INLINE Vector power_of_two(Vector n) {
  const auto biased = round(hn::Add(n, constant(1023.0))).bits;
  return hn::BitCast(tag, hn::ShiftLeft<52>(biased));
}

// c[0] + x (c[1] + x (c[2] + ...)).
template <std::size_t N>
HWY_INLINE Vector polynomial(const std::array<double, N>& c, Vector x) {
  Vector sum = constant(c[N - 1]);
  for (std::size_t i = N - 1; i-- > 0;) sum = hn::MulAdd(sum, x, constant(c[i]));
  return sum;
}

// c[0] + x (c[1] + ... + x (c[N-1] + x rest)) with double-double coefficients, each larger than the sum that
// is added to it. Normalised only at the end: until then lo is a few units in the last place of hi.
template <std::size_t N>
HWY_INLINE Real polynomial(const std::array<DoubleDouble, N>& c, const Real& x, Vector rest) {
  Vector hi = rest, lo = hn::Zero(tag);
  for (std::size_t i = N; i-- > 0;) {
    const Real product = two_product(hi, x.hi);
    const Vector cross = hn::MulAdd(hi, x.lo, hn::MulAdd(lo, x.hi, product.lo));
    const Real sum = quick_two_sum(constant(c[i].hi), product.hi);
    hi = sum.hi;
    lo = hn::Add(sum.lo, hn::Add(cross, constant(c[i].lo)));
  }
  return quick_two_sum(hi, lo);
}

HWY_INLINE Real gather_entries(const double* hi, const double* lo, hn::Vec<hn::RebindToSigned<Tag>> index) {
  return {hn::GatherIndex(tag, hi, index), hn::GatherIndex(tag, lo, index)};
}

// e^x = mantissa * 2^exponent, 1 <= mantissa < 2: x = (64 n + j) ln 2 / 64 + r.
struct Exponential {
  Real mantissa;
  Vector exponent;
};
HWY_INLINE Exponential exponential(const Real& x) {
  const auto& table = ElementaryTables::get();
  const hn::RebindToSigned<Tag> integers;
  const Rounded k = round(hn::Mul(x.hi, constant(ElementaryTables::exponential_steps / ln2.hi)));
  const Real step = constant(table.exponential_step);
  const Real whole = two_product(k.value, step.hi);
  const Real rest = two_sum(hn::Sub(x.hi, whole.hi), hn::Sub(x.lo, whole.lo));
  const Real r = rest + hn::Neg(hn::Mul(k.value, step.lo));
  const Real series = polynomial(exponential_head, r, polynomial(exponential_tail, r.hi));
  const auto j = hn::And(k.bits, hn::Set(integers, ElementaryTables::exponential_steps - 1));
  const Vector n = hn::Floor(hn::Mul(k.value, constant(1.0 / ElementaryTables::exponential_steps)));
  return {gather_entries(table.exponentials_hi.data(), table.exponentials_lo.data(), j) * series, n};
}

// e^(i y): y = (256 n + j) 2 pi / 256 + r; |y| < 2^40.
HWY_INLINE ComplexVector exp_i(const Real& y) {
  const auto& table = ElementaryTables::get();
  const hn::RebindToSigned<Tag> integers;
  const Rounded k = round(hn::Mul(y.hi, constant(ElementaryTables::angles / (2.0 * pi_double_double.hi))));
  const Real step = constant(table.angle_step);
  const Real whole = two_product(k.value, step.hi), finer = two_product(k.value, step.lo);
  const Real head = two_sum(hn::Sub(y.hi, whole.hi), hn::Neg(whole.lo));
  const Real r =
      (head + y.lo) - Real{finer.hi, hn::MulAdd(k.value, constant(table.angle_step_rest), finer.lo)};
  const Real square = r * r;
  const Real sine = r * polynomial(sine_head, square, polynomial(sine_tail, square.hi));
  const Real cosine = polynomial(cosine_head, square, polynomial(cosine_tail, square.hi));
  const auto j = hn::And(k.bits, hn::Set(integers, ElementaryTables::angles - 1));
  const ComplexVector turned{gather_entries(table.cosines_hi.data(), table.cosines_lo.data(), j),
                             gather_entries(table.sines_hi.data(), table.sines_lo.data(), j)};
  return turned * ComplexVector{cosine, sine};
}

// e^z. Precondition: no overflow or underflow.
HWY_INLINE ComplexVector exponential(const ComplexVector& z) {
  const Exponential size = exponential(z.re);
  return exp_i(z.im) * scale(size.mantissa, power_of_two(size.exponent));
}

}  // namespace fde::reference::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
