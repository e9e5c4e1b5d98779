// SPDX-License-Identifier: MIT
// Several numbers at once, each an unevaluated sum of N doubles, and their elementary functions. Included
// once for each vector target.

#if defined(FDE_MULTIPLE_DOUBLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef FDE_MULTIPLE_DOUBLES_INL
#undef FDE_MULTIPLE_DOUBLES_INL
#else
#define FDE_MULTIPLE_DOUBLES_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DoubleTag = hn::CappedTag<double, 8>;
using DoubleVector = hn::Vec<DoubleTag>;

struct RoundedDouble {
  DoubleVector value, error;
};

// Precondition: |a| >= |b|, or a = 0.
HWY_INLINE RoundedDouble quick_two_sum(DoubleVector a, DoubleVector b) {
  const auto sum = hn::Add(a, b);
  return {sum, hn::Sub(b, hn::Sub(sum, a))};
}

HWY_INLINE RoundedDouble two_sum(DoubleVector a, DoubleVector b) {
  const auto sum = hn::Add(a, b), added = hn::Sub(sum, a);
  return {sum, hn::Add(hn::Sub(a, hn::Sub(sum, added)), hn::Sub(b, added))};
}

#if !HWY_NATIVE_FMA
HWY_INLINE DoubleVector leading_half(DoubleVector x) {
  const auto t = hn::Mul(hn::Set(DoubleTag(), 134217729.0), x);  // 2^27 + 1
  return hn::Sub(t, hn::Sub(t, x));
}
#endif

HWY_INLINE RoundedDouble two_product(DoubleVector a, DoubleVector b) {
  const auto product = hn::Mul(a, b);
#if HWY_NATIVE_FMA
  return {product, hn::MulSub(a, b, product)};
#else
  const auto a_hi = leading_half(a), b_hi = leading_half(b), a_lo = hn::Sub(a, a_hi), b_lo = hn::Sub(b, b_hi);
  const auto rest =
      hn::Add(hn::Sub(hn::Mul(a_hi, b_hi), product), hn::Add(hn::Mul(a_hi, b_lo), hn::Mul(a_lo, b_hi)));
  return {product, hn::Add(rest, hn::Mul(a_lo, b_lo))};
#endif
}

// Sums of N parts, the first the largest: two of them have 31 digits (Dekker, Numer. Math. 18, 1971), three
// 46, four 62 (Hida, Li & Bailey, 15th IEEE Symposium on Computer Arithmetic, 2001).
template <std::size_t N>
class MultipleDoubles {
 public:
  static constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());
  static constexpr int digits = static_cast<int>(31 * N / 2);

  HWY_INLINE explicit MultipleDoubles(double x) : MultipleDoubles(hn::Set(DoubleTag(), x)) {}
  HWY_INLINE explicit MultipleDoubles(std::size_t n) : MultipleDoubles(static_cast<double>(n)) {}
  HWY_INLINE explicit MultipleDoubles(DoubleVector x) {
    parts.fill(hn::Zero(DoubleTag()));
    parts[0] = x;
  }
  static HWY_INLINE MultipleDoubles of_doubles(const double* values) {
    return MultipleDoubles(hn::LoadU(DoubleTag(), values));
  }
  static HWY_INLINE MultipleDoubles constant(const std::array<double, 4>& values) {
    MultipleDoubles x(values[0]);
    for (std::size_t i = 1; i < N; ++i) x.parts[i] = hn::Set(DoubleTag(), values[i]);
    return x;
  }
  static HWY_INLINE MultipleDoubles pi() {
    return constant(
        {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53, -0x1.f1976b7ed8fbcp-109, 0x1.4cf98e804177dp-163});
  }
  static HWY_INLINE MultipleDoubles ln2() {
    return constant(
        {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56, 0x1.7b57a079a1934p-111, -0x1.ace93a4ebe5d1p-165});
  }

  // Adds x, which is as large as the part k. Rounding errors go to the following parts.
  HWY_INLINE void add(std::size_t k, DoubleVector x) {
    for (; k + 1 < N; ++k) {
      const RoundedDouble sum = two_sum(parts[k], x);
      parts[k] = sum.value;
      x = sum.error;
    }
    parts[N - 1] = hn::Add(parts[N - 1], x);
  }

  // Adds a b.
  HWY_INLINE void add_product(const MultipleDoubles& a, const MultipleDoubles& b) {
    auto last = hn::Mul(a.parts[0], b.parts[N - 1]);
    for (std::size_t i = 1; i < N; ++i) last = hn::MulAdd(a.parts[i], b.parts[N - 1 - i], last);
    for (std::size_t k = 0; k + 1 < N; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        const RoundedDouble product = two_product(a.parts[i], b.parts[k - i]);
        add(k, product.value);
        if (k + 2 < N) {
          add(k + 1, product.error);
        } else {
          last = hn::Add(last, product.error);
        }
      }
    }
    parts[N - 1] = hn::Add(parts[N - 1], last);
  }

  // Makes each part at most half a unit in the last place of the one before. Parts that are 0 because others
  // have cancelled go to the end.
  [[nodiscard]] HWY_INLINE MultipleDoubles normalised() const {
    MultipleDoubles x = *this;
    for (std::size_t i = N - 1; i-- > 0;) {
      const RoundedDouble sum = two_sum(x.parts[i], x.parts[i + 1]);
      x.parts[i] = sum.value;
      x.parts[i + 1] = sum.error;
    }
    for (std::size_t end = N > 2 ? N - 1 : 0; end > 0; --end) {
      for (std::size_t i = 0; i < end; ++i) {
        const RoundedDouble sum = quick_two_sum(x.parts[i], x.parts[i + 1]);
        x.parts[i] = sum.value;
        x.parts[i + 1] = sum.error;
      }
    }
    return x;
  }

  [[nodiscard]] HWY_INLINE MultipleDoubles scaled(DoubleVector power_of_two) const {
    MultipleDoubles x = *this;
    for (auto& part : x.parts) part = hn::Mul(part, power_of_two);
    return x;
  }

  std::array<DoubleVector, N> parts;
};

template <std::size_t N>
HWY_INLINE MultipleDoubles<N> sum_of(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) {
  MultipleDoubles<N> sum = a;
  for (std::size_t k = 0; k < N; ++k) sum.add(k, b.parts[k]);
  return sum.normalised();
}
template <std::size_t N>
HWY_INLINE MultipleDoubles<N> product_of(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) {
  MultipleDoubles<N> product(0.0);
  product.add_product(a, b);
  return product.normalised();
}

// Operations of two parts are inlined, longer ones are called.
HWY_INLINE MultipleDoubles<2> operator+(const MultipleDoubles<2>& a, const MultipleDoubles<2>& b) {
  return sum_of(a, b);
}
HWY_INLINE MultipleDoubles<2> operator*(const MultipleDoubles<2>& a, const MultipleDoubles<2>& b) {
  return product_of(a, b);
}
template <std::size_t N>
MultipleDoubles<N> operator+(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) {
  return sum_of(a, b);
}
template <std::size_t N>
MultipleDoubles<N> operator*(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) {
  return product_of(a, b);
}
template <std::size_t N>
HWY_INLINE MultipleDoubles<N> operator-(const MultipleDoubles<N>& a) {
  return a.scaled(hn::Set(DoubleTag(), -1.0));
}
template <std::size_t N>
HWY_INLINE MultipleDoubles<N> operator-(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) {
  return a + -b;
}
// Long division, one double at a time.
template <std::size_t N>
MultipleDoubles<N> operator/(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) {
  const auto inverse = hn::Div(hn::Set(DoubleTag(), 1.0), b.parts[0]);
  MultipleDoubles<N> rest = a, quotient(0.0);
  for (std::size_t k = 0; k <= N; ++k) {
    const auto digit = hn::Mul(rest.parts[0], inverse);
    quotient.add(k < N ? k : N - 1, digit);
    if (k < N) rest = rest - b * MultipleDoubles<N>(digit);
  }
  return quotient.normalised();
}

template <class Real>
class SumOfProducts;
template <std::size_t N>
class SumOfProducts<MultipleDoubles<N>> {
 public:
  HWY_INLINE SumOfProducts() : sum_(0.0) {}
  void add(const MultipleDoubles<N>& a, const MultipleDoubles<N>& b) { sum_.add_product(a, b); }
  [[nodiscard]] MultipleDoubles<N> value() const { return sum_.normalised(); }

 private:
  MultipleDoubles<N> sum_;
};

// An array of numbers. each(i) has the number i in all lanes, from(i) the numbers i, i+1, ...; put() writes
// all lanes and set() the first.
template <class Real>
class Numbers;
template <std::size_t N>
class Numbers<MultipleDoubles<N>> {
 public:
  explicit Numbers(std::size_t size = 0) : size_(size), parts_(N * size) {}
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double rounded(std::size_t i) const { return parts_[i]; }
  [[nodiscard]] HWY_INLINE MultipleDoubles<N> each(std::size_t i) const {
    MultipleDoubles<N> x(0.0);
    for (std::size_t k = 0; k < N; ++k) x.parts[k] = hn::Set(DoubleTag(), *at(k, i));
    return x;
  }
  [[nodiscard]] HWY_INLINE MultipleDoubles<N> from(std::size_t i) const {
    MultipleDoubles<N> x(0.0);
    for (std::size_t k = 0; k < N; ++k) x.parts[k] = hn::LoadU(DoubleTag(), at(k, i));
    return x;
  }
  HWY_INLINE void put(std::size_t i, const MultipleDoubles<N>& x) {
    for (std::size_t k = 0; k < N; ++k) hn::StoreU(x.parts[k], DoubleTag(), at(k, i));
  }
  HWY_INLINE void set(std::size_t i, const MultipleDoubles<N>& x) {
    for (std::size_t k = 0; k < N; ++k) *at(k, i) = hn::GetLane(x.parts[k]);
  }
  void copy(std::size_t i, const Numbers& other, std::size_t j) {
    for (std::size_t k = 0; k < N; ++k) *at(k, i) = *other.at(k, j);
  }

 private:
  // The part k of the number i.
  [[nodiscard]] const double* at(std::size_t k, std::size_t i) const { return parts_.data() + k * size_ + i; }
  [[nodiscard]] double* at(std::size_t k, std::size_t i) { return parts_.data() + k * size_ + i; }

  std::size_t size_;
  std::vector<double> parts_;
};

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
