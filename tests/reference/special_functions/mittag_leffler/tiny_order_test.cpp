// SPDX-License-Identifier: MIT
// Orders so small that E_{alpha,beta}(z) is 1 / ((1-z) Gamma(beta)) or, at a zero of 1/Gamma,
// alpha (1/Gamma)'(beta) z/(1-z)^2, for every |beta|.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct TinyOrder {
  double alpha, beta;
  Value z, value;
};

// The number of progress reports of a call: 0 where no contour in multiprecision is needed.
template <class Call>
std::size_t work_of(const Call& call) {
  std::size_t work = 0;
  const ProgressScope scope([&](std::size_t, std::size_t) { ++work; });
  call();
  return work;
}

// The power series for |z| < 1, otherwise -sum z^-k / Gamma(beta - alpha k), in mpmath with 420 digits.
TEST(TinyOrders, MeetSeriesWithoutWork) {
  for (const auto& [alpha, beta, z, value] :
       {TinyOrder{2.0851374e-317, 168.00402843958, {3.0, 1.390671161592297e-309}, -3.2574186930803867e-301},
        TinyOrder{5e-324, -182.0, {-0.5, 2.0}, {-9312065658.7324719, -5440757463.5290847}},
        TinyOrder{1e-300, 150.5, -3.0, 5.3635722933518037e-263},
        TinyOrder{1e-310, -160.25, 0.5, -7.555701904967478e+284},
        TinyOrder{1e-40, -1e-12, -5.0, -1.6666666666657046e-13},
        TinyOrder{1e-25, -3.0, {2.0, 1e-22}, {-1.2e-24, 1.8e-46}},
        TinyOrder{1e-32, 0.75, {1.001, 1e-20}, {-816.04893909835286, 8.1604893909844269e-15}},
        TinyOrder{3e-60, 6e-60, {0.0, 1e5}, {5.9999999988004e-80, 3.0000000003e-65}},
        TinyOrder{1e-50, 170.0, {1e200, 1e180}, 0.0}}) {
    const auto work = work_of([&, alpha = alpha, beta = beta, z = z, value = value] {
      const auto [found, bound] = mittag_leffler(alpha, beta, z);
      EXPECT_LE(std::abs(found - value), bound + 2e-16 * std::abs(value)) << alpha << ' ' << beta;
      EXPECT_LE(bound, 8.0 * 0x1p-53 * std::abs(value) + std::numeric_limits<double>::denorm_min());
    });
    EXPECT_EQ(work, 0U) << alpha << ' ' << beta;
  }
}

// For |beta| > 180 the value underflows or overflows, with the sign of 1/Gamma(beta) / (1-z).
TEST(TinyOrders, OverflowOrVanishWithoutWorkForLargeParameters) {
  const auto value = [](double alpha, double beta, Value z) { return mittag_leffler(alpha, beta, z).value; };
  const auto work = work_of([&] {
    for (const double alpha : {5e-324, 1e-200, 1e-40}) {
      EXPECT_EQ(value(alpha, -500.5, -3.0), -infinity);
      EXPECT_EQ(value(alpha, -9000.5, 0.5), -infinity);
      EXPECT_EQ(value(alpha, -9001.5, {0.5, 1e-3}), Value(infinity, infinity));
      EXPECT_EQ(value(alpha, -9000.0, -2.0), -infinity);
      EXPECT_EQ(value(alpha, 9000.5, {3.0, 1.0}), 0.0);
      EXPECT_EQ(mittag_leffler(alpha, 9000.5, {3.0, 1.0}).bound, std::numeric_limits<double>::denorm_min());
      EXPECT_EQ(mittag_leffler(alpha, -9000.5, {3.0, 1.0}).bound, infinity);
    }
  });
  EXPECT_EQ(work, 0U);
}

// s* = z^(1/alpha) overflows: e^s* is 0 for arg s* above a right angle, and below it its phase cannot be
// computed.
TEST(TinyOrders, TellPolesOnBothSidesOfTheImaginaryAxis) {
  constexpr double alpha = 1e-209, beyond = 1.0 + 1e-14, below = 1.0 - 1e-14;
  const auto at = [&](double part) {
    return mittag_leffler(alpha, 21.5, Value(3.0, 3.0 * alpha * part * std::numbers::pi / 2.0)).value;
  };
  mittag_leffler(0.5, 1.0, -1.0);  // computes the tables
  const auto work = work_of([&] {
    EXPECT_NEAR(at(beyond).real() * std::tgamma(21.5), -0.5, 1e-14);
    EXPECT_THROW(at(below), std::runtime_error);
  });
  EXPECT_EQ(work, 0U);
}

}  // namespace
}  // namespace fde::reference
