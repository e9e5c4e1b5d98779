// SPDX-License-Identifier: MIT
// The same input gives the same bits on repeated runs and on every processor with fused multiply-add, and
// nearly the same on others. Numbers of threads: tests/benchmarks/sweep/sweep_records_test.cpp; kinds of
// history: tests/conformance/conformance_test.cpp.

#include "conformance/bits.hpp"

#include <gtest/gtest.h>

#include "fdebench/schemes/history/block_kernels.hpp"

namespace fde::bench {
namespace {

void expect_near(const std::vector<FinalValues>& here, const std::vector<FinalValues>& there, double ulps) {
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    ASSERT_EQ(here[i].run, there[i].run);
    EXPECT_LE(ulps_between(here[i], there[i].values), ulps) << here[i].run;
  }
}

TEST(Bits, AreTheSameOnRepeatedRuns) { expect_near(final_values(), final_values(), 0.0); }

// A different order of summation changes a result by some 32 units in the last place after 1500 steps, an
// error in a weight by far more than a thousand.
TEST(Bits, AreNearThoseOfTheTable) {
  expect_near(final_values(), read_final_values(FDE_SOURCE_DIR "/tests/bits.txt"), 1024.0);
}

class BitsOfTarget : public testing::TestWithParam<std::string_view> {
 protected:
  void TearDown() override { select_vector_target(vector_targets().front()); }
};

// Without fused operations (SSE, scalar) the memory term is rounded differently, and the difference remains
// until the end of a run of 1500 steps.
TEST_P(BitsOfTarget, AreThoseOfTheWidestTarget) {
  static const auto widest = [] {
    select_vector_target(vector_targets().front());
    return final_values();
  }();
  select_vector_target(GetParam());
  expect_near(final_values(), widest, GetParam().starts_with("AVX") ? 0.0 : 32.0);
}

INSTANTIATE_TEST_SUITE_P(, BitsOfTarget, testing::ValuesIn(vector_targets()),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace fde::bench
