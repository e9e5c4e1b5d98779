// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/mittag_leffler_request.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal_of.hpp"

namespace fde::bench {
namespace {

std::vector<reference::MittagLefflerValue> doubles(const MittagLefflerRequest& request) {
  return std::get<std::vector<reference::MittagLefflerValue>>(mittag_leffler(request));
}

reference::DecimalComplex real(const std::string& x) { return {x, "0", "0"}; }

// E_{1,1}(-1) = exp(-1) and E_{2,1}(-x^2) = cos x.
TEST(MittagLefflerRequests, AreExponentialsAndCosines) {
  const auto exponential = doubles({.alpha = "1", .argument = real("-1")}).front();
  EXPECT_LE(std::abs(exponential.value - std::exp(-1.0)), exponential.bound + 1e-16);
  const auto cosine = doubles({.alpha = "2", .argument = real("-2.25")}).front();
  EXPECT_LE(std::abs(cosine.value - std::cos(1.5)), cosine.bound + 1e-16);
}

// The derivative of exp is exp, and E^(-1)_{1,1}(z) = 1 - z.
TEST(MittagLefflerRequests, TakeADerivativeOrAThirdParameter) {
  const auto derivative = doubles({.alpha = "1", .argument = real("0.5"), .derivative = 2}).front();
  EXPECT_LE(std::abs(derivative.value - std::exp(0.5)), derivative.bound + 4e-16);
  const auto prabhakar = doubles({.alpha = "1", .argument = real("3"), .gamma = "-1"}).front();
  EXPECT_LE(std::abs(prabhakar.value + 2.0), prabhakar.bound);
}

TEST(MittagLefflerRequests, OfADiagonalMatrixAreThoseOfItsEntries) {
  const std::vector diagonal{real("-0.5"), real("0"), real("0"), real("-3")};
  const auto entries = doubles({.alpha = "0.75", .argument = diagonal});
  for (const std::size_t i : {0, 3}) {
    const auto number = doubles({.alpha = "0.75", .argument = diagonal[i]}).front();
    EXPECT_LE(std::abs(entries[i].value - number.value), entries[i].bound + number.bound) << i;
  }
  EXPECT_LE(std::abs(entries[1].value), entries[1].bound);
}

TEST(MittagLefflerRequests, HaveAsManyDigitsAsAreAsked) {
  const auto values = mittag_leffler({.alpha = "0.5", .argument = real("-1"), .digits = 30});
  EXPECT_EQ(std::get<std::vector<reference::DecimalComplex>>(values).front().re,
            "0.427583576155807004410750344491");
}

TEST(MittagLefflerRequests, NameTheFieldThatTheyRefuse) {
  const auto refused = [](const MittagLefflerRequest& request) {
    return refusal_of([&] { mittag_leffler(request); });
  };
  const std::vector one{real("1")};
  EXPECT_EQ(refused({.alpha = "6", .argument = real("1")}), "<alpha> = 6: must be a number in (0, 5]");
  EXPECT_EQ(refused({.alpha = "1", .beta = "x", .argument = real("1")}),
            "<beta> = x: must be a number in [-10000, 10000]");
  EXPECT_EQ(refused({.alpha = "1", .argument = real("one")}), "<z> = one: must be a finite number");
  EXPECT_EQ(refused({.alpha = "1", .argument = one, .gamma = "2"}), "<gamma> = 2: must be without <matrix>");
  EXPECT_EQ(refused({.alpha = "1", .argument = real("1"), .derivative = 1, .gamma = "2"}),
            "<gamma> = 2: must be without <derivative>");
  EXPECT_EQ(refused({.alpha = "1", .argument = real("1"), .digits = 0}),
            "<digits> = 0: must be a whole number from 1 to 100000");
}

}  // namespace
}  // namespace fde::bench
