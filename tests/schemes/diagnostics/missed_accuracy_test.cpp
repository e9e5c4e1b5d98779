// SPDX-License-Identifier: MIT
// A run that chooses its steps and is off by more than it was asked says so, by about how much.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fdebench/schemes/diagnostics/warnings.hpp"
#include "support/command_line_result.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using testing::DoubleEq;

// Runs whose error in one value is so many times what they are asked for.
struct Runs {
  double times;
  Rows exact = Rows{{1.0, -3.0}, {0.0, 1e3}};
  std::vector<double> asked{};

  [[nodiscard]] Rows values(const Tolerance& accuracy) const {
    Rows result = exact;
    result(1, 0) += times * accuracy.atol;
    return result;
  }
  std::optional<MissedAccuracy> missed(bool check = false) {
    constexpr Tolerance accuracy{.rtol = 1e-6, .atol = 1e-6};
    const auto other = [this](const Tolerance& another) {
      asked.push_back(another.rtol);
      return std::optional(values(another));
    };
    return missed_accuracy(accuracy, values(accuracy), other, check);
  }
};

TEST(MissedAccuracy, IsTheErrorWhereErrorsAreInProportionToWhatIsAsked) {
  for (const double times : {6.0, 48.0, 90.0}) {
    Runs runs{times};
    const auto missed = runs.missed();
    ASSERT_TRUE(missed);
    EXPECT_NEAR(missed->times, times, 1e-3 * times);
    EXPECT_EQ(missed->row, 1);
    EXPECT_EQ(missed->column, 0);
  }
}

TEST(MissedAccuracy, IsNoneWithinFiveTimesAndOneOtherRunSaysSoOfAGoodOne) {
  Runs good{1.0}, poor{4.5};
  EXPECT_FALSE(good.missed());
  EXPECT_THAT(good.asked, ElementsAre(DoubleEq(1e-5)));
  EXPECT_FALSE(poor.missed());
  EXPECT_EQ(poor.asked.size(), 2U);
  Runs checked{1.0};
  EXPECT_FALSE(checked.missed(true));
  EXPECT_NEAR(checked.asked.back(), 1e-7, 1e-20);
}

// The looser run is off by more than in proportion: the finer one acquits. Where that does not end, the
// looser one is believed.
TEST(MissedAccuracy, IsDecidedByTheFinerRun) {
  const Tolerance accuracy{.rtol = 1e-6, .atol = 1e-6};
  const Rows exact = Rows::Ones(1, 1);
  const auto apart = [&](const Tolerance& another) -> std::optional<Rows> {
    return Rows(exact.array() + (another.rtol > 1e-6 ? 1e-3 : 0.0));
  };
  EXPECT_FALSE(missed_accuracy(accuracy, exact, apart));
  const auto alone = [&](const Tolerance& another) {
    return another.rtol > 1e-6 ? apart(another) : std::nullopt;
  };
  EXPECT_NEAR(missed_accuracy(accuracy, exact, alone)->times, 1e-3 / 9.0 / 2e-6, 1e-3);
  EXPECT_FALSE(missed_accuracy(accuracy, exact, [](const Tolerance&) { return std::nullopt; }));
}

// y'' = -1e6 y over 160 periods, in which errors of steps add up; y(1) = cos 1000.
TEST(MissedAccuracy, OfALongOscillationIsSaid) {
  const std::string command =
      "solve stiff_relaxation:gamma=2 --scheme adaptive_trapezoidal --accuracy 9e-06 --at 1";
  const auto answer = fdebench(command);
  EXPECT_EQ(answer.code, 0);
  const double off =
      std::abs(csv_rows(answer.out).back().at(1) - std::cos(1000.0)) / (1.0 + std::cos(1000.0));
  const std::string beginning = "fdebench: warning: y at t = 1 is off by about ";
  ASSERT_THAT(answer.err, StartsWith(beginning));
  EXPECT_NEAR(off / 9e-6, 48.0, 1.0);
  // From a run with ten times the tolerance, or, where its time suffices, from one with a tenth.
  EXPECT_NEAR(std::stod(answer.err.substr(beginning.size())), 48.0, 5.0);
  const auto strict = fdebench(command + " --strict");
  EXPECT_EQ(strict.code, 3);
  EXPECT_THAT(strict.out, IsEmpty());
}

// Damped motion that magnifies a change of q1(0) by 580.
TEST(MissedAccuracy, OfAnIllConditionedMotionIsSaid) {
  const auto answer = fdebench(
      "solve isokinetic --scheme adaptive_trapezoidal --accuracy 1e-4 --at 10 --set k=15.232 --set c=3.927 "
      "--set "
      "q1=.688 --set q2=-.939 --set q3=.799 --set v1=.245 --set v2=-.367 --set v3=-.136");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.err, HasSubstr("times the requested accuracy"));
}

TEST(MissedAccuracy, IsNotSaidOfWhatIsDelivered) {
  for (const auto* scheme :
       {"spectral_collocation", "adaptive_trapezoidal", "adaptive_pc", "radau_exponentials"}) {
    for (const auto* scene : {"relaxation", "pendulum", "bagley_torvik", "linear_system"}) {
      const auto answer =
          fdebench(fmt::format("solve {} --scheme {} --accuracy 1e-5 --check", scene, scheme));
      EXPECT_EQ(answer.code, 0) << scene;
      EXPECT_EQ(answer.err, "") << scene << ' ' << scheme;
    }
  }
}

}  // namespace
}  // namespace fde::bench
