// SPDX-License-Identifier: MIT
// A recomputed value is compared with a given one only if it is accurate enough.

#include "fdebench/benchmarks/reference_data/table_comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "support/matchers.hpp"

namespace fde::bench {
namespace {

constexpr int digits = 9;

void require_accurate(const DataTable& given, const reference::Decimal& re,
                      const reference::Decimal& im = {"0", "0"}) {
  TableComparison(given, {"re", "im"}).require_accurate(0, {re, im}, digits);
}

// 0 with a bound of 8e+6876 would agree with every number.
TEST(TableComparison, ABoundBeyondEverythingIsNoValue) {
  const DataTable given{.name = "a.csv", .columns = {"re"}, .rows = {{"12345.6789"}}};
  EXPECT_TRUE(TableComparison(given, {"re"})(0, {{"0", "8e+6876"}}).holds());
  EXPECT_THAT(
      [&] {
        require_accurate(given, {"0", "8e+6876"});
      },
      ThrowsMessage<std::runtime_error>(
          HasSubstr("no value to compare re with: recomputed as 0, with a bound of 8e+6876")));
}

// The allowed bound is half a unit in the last place, 5e-5, or 1e-9 of the value, 1.2e-5 and 1.2e-4.
TEST(TableComparison, AValueKnownToTheDigitsGivenOrAskedForIsOne) {
  const DataTable given{.name = "a.csv", .columns = {"re"}, .rows = {{"12345.6789"}}};
  EXPECT_NO_THROW(require_accurate(given, {"12345.6789", "4.9e-5"}));
  EXPECT_THROW(require_accurate(given, {"12345.6789", "5.1e-5"}), std::runtime_error);
  EXPECT_NO_THROW(require_accurate(given, {"123456.789", "1.2e-4"}));
  EXPECT_THROW(require_accurate(given, {"123456.789", "1.3e-4"}), std::runtime_error);
}

TEST(TableComparison, ABoundThatIsGivenCountsForTheDigits) {
  const DataTable given{.name = "a.csv", .columns = {"re", "bound"}, .rows = {{"1.00000000", "1e-3"}}};
  EXPECT_NO_THROW(require_accurate(given, {"1", "9e-4"}));
  EXPECT_THROW(require_accurate(given, {"1", "1.1e-3"}), std::runtime_error);
}

// The bound of a complex value is relative to its modulus.
TEST(TableComparison, APartMayBeAsBadAsTheLargerOneAllows) {
  const DataTable given{.name = "a.csv", .columns = {"re", "im"}, .rows = {{"1.00000000000", "1.5e-30"}}};
  EXPECT_NO_THROW(require_accurate(given, {"1", "1e-12"}, {"0", "1e-12"}));
  EXPECT_THROW(require_accurate(given, {"1", "1e-12"}, {"0", "1e-8"}), std::runtime_error);
}

}  // namespace
}  // namespace fde::bench
