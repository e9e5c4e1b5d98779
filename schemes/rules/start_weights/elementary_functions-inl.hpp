// SPDX-License-Identifier: MIT
// Exponential, logarithm, sine and cosine of MultipleDoubles. Included once for each vector target.

#if defined(FDE_ELEMENTARY_FUNCTIONS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_ELEMENTARY_FUNCTIONS_INL
#undef FDE_ELEMENTARY_FUNCTIONS_INL
#else
#define FDE_ELEMENTARY_FUNCTIONS_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "fdebench/schemes/rules/start_weights/multiple_doubles-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// 1 / k!, as many as the series below need.
template <std::size_t N>
const Numbers<MultipleDoubles<N>>& reciprocal_factorials() {
  static const auto values = []() HWY_ATTR {
    Numbers<MultipleDoubles<N>> made(N == 2 ? 28 : N == 3 ? 40 : 50);
    MultipleDoubles<N> value(1.0);
    for (std::size_t k = 0; k < made.size(); ++k) {
      if (k > 1) value = value / MultipleDoubles<N>(k);
      made.set(k, value);
    }
    return made;
  }();
  return values;
}

// x = n ln 2 + r, |r| <= 0.35. The last terms of the series need no more than a double.
template <std::size_t N>
MultipleDoubles<N> exp(const MultipleDoubles<N>& x) {
  constexpr DoubleTag tag;
  constexpr std::size_t last = N == 2   ? 24
                               : N == 3 ? 34
                                        : 43,
                        last_of_all_parts = N == 2   ? 14
                                            : N == 3 ? 25
                                                     : 36;
  const auto& inverse = reciprocal_factorials<N>();
  const auto n = hn::Round(hn::Mul(x.parts[0], hn::Set(tag, 1.4426950408889634)));
  const auto r = x - MultipleDoubles<N>::ln2() * MultipleDoubles<N>(n);
  auto tail = hn::Set(tag, inverse.rounded(last));
  for (std::size_t k = last - 1; k > last_of_all_parts; --k)
    tail = hn::MulAdd(tail, r.parts[0], hn::Set(tag, inverse.rounded(k)));
  MultipleDoubles<N> sum(tail);
  for (std::size_t k = last_of_all_parts + 1; k-- > 0;) sum = sum * r + inverse.each(k);
  const hn::RebindToSigned<DoubleTag> integers;
  const auto magic = hn::Set(tag, 6755399441055744.0 + 1023.0);  // 1.5 * 2^52: low bits are the integer
  return sum.scaled(hn::BitCast(tag, hn::ShiftLeft<52>(hn::BitCast(integers, hn::Add(n, magic)))));
}

// Steps of Halley's method from the logarithm of the leading part.
template <std::size_t N>
MultipleDoubles<N> log(const MultipleDoubles<N>& x) {
  std::array<double, 8> values{};
  hn::StoreU(x.parts[0], DoubleTag(), values.data());
  for (double& value : values) value = std::log(value);
  auto logarithm = MultipleDoubles<N>::of_doubles(values.data());
  for (std::size_t step = 0; 2 * step < N; ++step) {
    const auto there = exp(logarithm);
    logarithm = logarithm + MultipleDoubles<N>(2.0) * (x - there) / (x + there);
  }
  return logarithm;
}

// y = n pi/2 + r, |r| <= pi/4. Precondition: |y| < 2^20.
template <class Real>
struct SineAndCosine {
  Real sine, cosine;
};
template <std::size_t N>
SineAndCosine<MultipleDoubles<N>> sine_and_cosine(const MultipleDoubles<N>& y) {
  using Real = MultipleDoubles<N>;
  constexpr DoubleTag tag;
  const auto& inverse = reciprocal_factorials<N>();
  const auto half = hn::Set(tag, 0.5), one = hn::Set(tag, 1.0), two = hn::Set(tag, 2.0);
  const auto n = hn::Round(hn::Mul(y.parts[0], hn::Set(tag, 0.6366197723675814)));
  const Real r = y - Real::pi() * Real(hn::Mul(n, half)), square = -(r * r);
  Real sine(0.0), cosine(0.0);
  for (std::size_t k = inverse.size() / 2; k-- > 0;) {
    sine = sine * square + inverse.each(2 * k + 1);
    cosine = cosine * square + inverse.each(2 * k);
  }
  sine = sine * r;
  // n modulo 4 = 2 upper + odd.
  const auto modulo = hn::Sub(n, hn::Mul(hn::Set(tag, 4.0), hn::Floor(hn::Mul(n, hn::Set(tag, 0.25)))));
  const auto upper = hn::Floor(hn::Mul(modulo, half)), odd = hn::Sub(modulo, hn::Mul(two, upper));
  const auto sign = hn::Sub(one, hn::Mul(two, upper)),
             of_cosine = hn::Mul(sign, hn::Sub(one, hn::Mul(two, odd)));
  const auto swapped = hn::Gt(odd, half);
  for (std::size_t i = 0; i < N; ++i) {
    const auto s = sine.parts[i], c = cosine.parts[i];
    sine.parts[i] = hn::Mul(sign, hn::IfThenElse(swapped, c, s));
    cosine.parts[i] = hn::Mul(of_cosine, hn::IfThenElse(swapped, s, c));
  }
  return {sine, cosine};
}

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
