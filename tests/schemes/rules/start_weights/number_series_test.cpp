// SPDX-License-Identifier: MIT
// Arithmetic and special functions of MultipleDoubles against MPFR, to the digits that each number of parts
// promises.

#include <gtest/gtest.h>

#include <boost/math/special_functions/zeta.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <random>

#include "fdebench/schemes/rules/start_weights/number_series-inl.hpp"

namespace fde::bench {
namespace {

using namespace HWY_NAMESPACE;

using Exact = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                            boost::multiprecision::et_off>;

template <class Real>
Exact exact(const Real& x) {
  Exact sum = 0;
  for (const auto& part : x.parts) sum += Exact(hn::GetLane(part));
  return sum;
}

template <class Real>
class NumberSeries : public testing::Test {
 protected:
  // In (0, largest), with random digits in all parts.
  Real random(double largest) {
    Real x(uniform_(random_) * largest);
    double size = largest;
    for (auto& part : x.parts) {
      part = hn::Add(part, hn::Set(DoubleTag(), (uniform_(random_) - 0.5) * size));
      size *= 0x1p-53;
    }
    return x + Real(largest);
  }
  // |value - expected| <= units 10^-digits |scale|.
  static void expect_near(const Real& value, const Exact& expected, const Exact& scale, double units) {
    const auto error = static_cast<double>(abs(exact(value) - expected) / abs(scale));
    EXPECT_LE(error, units * std::pow(10.0, -Real::digits)) << static_cast<double>(expected);
  }

 private:
  std::mt19937_64 random_{1};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};
using Lengths = testing::Types<MultipleDoubles<2>, MultipleDoubles<3>, MultipleDoubles<4>>;
TYPED_TEST_SUITE(NumberSeries, Lengths);

TYPED_TEST(NumberSeries, ComputesSumsProductsAndQuotients) {
  for (int i = 0; i < 200; ++i) {
    const auto a = this->random(1.0), b = this->random(3.0);
    const Exact x = exact(a), y = exact(b);
    this->expect_near(a + b, x + y, x + y, 1.0);
    this->expect_near(a - b, x - y, x + y, 1.0);
    this->expect_near(a * b, x * y, x * y, 1.0);
    this->expect_near(a / b, x / y, x / y, 1.0);
  }
}

// Where leading parts cancel, the first part is still the whole number rounded.
TYPED_TEST(NumberSeries, NormalisesWhatCancels) {
  for (int i = 0; i < 100; ++i) {
    const auto a = this->random(1.0);
    for (const double size : {1e-8, 1e-16, 1e-20}) {
      const auto small = this->random(size);
      SumOfProducts<TypeParam> sum;
      sum.add(a, TypeParam(1e10));
      sum.add(small, TypeParam(1.0));
      sum.add(a, TypeParam(-1e10));
      this->expect_near(sum.value(), exact(small), Exact(1e10), 3.0);
      const auto rounded = static_cast<double>(exact(sum.value()));
      EXPECT_EQ(hn::GetLane(sum.value().parts[0]), rounded);
    }
  }
}

TYPED_TEST(NumberSeries, ComputesElementaryFunctions) {
  for (int i = 0; i < 200; ++i) {
    const auto x = this->random(6.0);
    for (const auto& y : {x, -x}) {
      this->expect_near(exp(y), exp(exact(y)), exp(exact(y)), 30.0);
      const auto [sine, cosine] = sine_and_cosine(y);
      this->expect_near(sine, sin(exact(y)), Exact(1), 4.0);
      this->expect_near(cosine, cos(exact(y)), Exact(1), 4.0);
    }
    this->expect_near(log(x), log(exact(x)), log(exact(x)), 2.0);
    this->expect_near(gamma(x), tgamma(exact(x)), tgamma(exact(x)), 60.0);
  }
}

// zeta(-p-k) (-1)^k / k!, relative to the size of the other factors of the functional equation.
TYPED_TEST(NumberSeries, ComputesZetaAtNegativeArguments) {
  constexpr std::size_t lanes = TypeParam::lanes, count = 36;
  for (const double p : {1e-4, 0.3, 1.0, 1.7, 4.9}) {
    Numbers<TypeParam> powers((stirling_from<TypeParam> + 1) * lanes);
    for (std::size_t j = 1; j <= stirling_from<TypeParam>; ++j)
      powers.put(j * lanes, exp(TypeParam(p) * log(TypeParam(j))));
    const auto values =
        zeta_series(TypeParam(p), gamma(TypeParam(p) + TypeParam(1.0)), powers, 0, lanes, count);
    Exact factor = 1;
    const Exact two_pi = 8 * atan(Exact(1));
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) factor /= -Exact(k);
      const Exact z = Exact(p) + k + 1;
      this->expect_near(values.from(k * lanes), factor * boost::math::zeta(Exact(1 - z)),
                        factor * pow(two_pi, -z) * tgamma(z), 60.0);
    }
  }
}

// (1 - t)^g (1 - t)^(-g) = 1.
TYPED_TEST(NumberSeries, MultipliesPowersOfSeries) {
  Numbers<TypeParam> a(2);
  a.set(0, TypeParam(1.0));
  a.set(1, TypeParam(-1.0));
  const TypeParam g(0.7), one(1.0);
  const auto unity = product(power_of_series(a, g, one, 40), power_of_series(a, -g, one, 40), 40);
  for (std::size_t k = 0; k < 40; ++k)
    this->expect_near(unity.each(k), Exact(k == 0 ? 1 : 0), Exact(1), 10.0);
}

}  // namespace
}  // namespace fde::bench
