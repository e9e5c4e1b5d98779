// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/setup_time.hpp"

#include <gtest/gtest.h>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// D^0.4711 y = -y, an order that no other test has.
Problem relaxation() {
  return {.components = {{0.4711, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }};
}

double settings_of(std::string_view scheme, const Resolution& resolution) {
  const SetupTime setup;
  find_scheme(scheme)->solve(relaxation(), resolution, {});
  return setup.seconds();
}

// The start weights of bdf4 are computed once and count in every solve: a later solve says what the first
// one took longer.
TEST(SetupTimes, OfALaterSolveAreThoseOfTheFirst) {
  const Grid grid{.end = 1.0, .steps = 16};
  const double first = settings_of("bdf4", grid);
  EXPECT_GT(first, 0.0);
  EXPECT_EQ(settings_of("bdf4", grid), first);
  EXPECT_GE(settings_of("bdf4", Grid{.end = 1.0, .steps = 1024}), first) << "more steps need more of them";
}

TEST(SetupTimes, AreNoneForASchemeThatRetainsNothing) {
  EXPECT_EQ(settings_of("l1", Grid{.end = 1.0, .steps = 16}), 0.0);
}

TEST(SetupTimes, CountTheTablesOfPanels) {
  EXPECT_GT(settings_of("spectral_collocation", Tolerance{1e-6, 1e-6}), 0.0);
}

// Only the newest object counts, and each table once.
TEST(SetupTimes, CountEachTableOnce) {
  const SetupTime outer;
  {
    const SetupTime inner;
    count_table(&inner, 1.0);
    count_table(&inner, 1.0);
    EXPECT_EQ(inner.seconds(), 1.0);
  }
  EXPECT_EQ(outer.seconds(), 0.0);
}

}  // namespace
}  // namespace fde::bench
