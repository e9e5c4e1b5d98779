// Steps that find their lengths: what they deliver, and what they cost.

#include <gtest/gtest.h>

#include <cmath>

#include "adaptive/step_control.hpp"
#include "mittag_leffler/mittag_leffler.hpp"
#include "references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

struct Asked {
  std::string scheme, scene;
  ParameterValues values{};
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const Asked& asked, std::ostream* out) {
  *out << asked.scheme << ' ' << SceneVariant{&scene_maker(asked.scene), asked.values}.label();
}

class Adaptive : public testing::TestWithParam<Asked> {};

// The largest error at sixty of the run's own times, of 1 + |y|.
double largest_error(const Scene& scene, const Trajectory& path) {
  const auto reference = reference_of(scene);
  double largest = 0.0;
  for (std::size_t i = 1; i < path.times.size(); i += 1 + path.times.size() / 60) {
    const auto exact = reference.at(path.times[i]);
    const Vec columns = columns_at(scene.outputs, path.times[i], path.y.col(static_cast<Eigen::Index>(i)));
    for (Eigen::Index c = 0; c < columns.size(); ++c) {
      const double error = std::abs(columns[c] - exact.value[c]) - exact.bound[c];
      largest = std::max(largest, error / (1.0 + std::abs(exact.value[c])));
    }
  }
  return largest;
}

// Errors of steps are estimated one by one; what they come to together is known to a factor of three here.
TEST_P(Adaptive, DeliversTheAccuracy) {
  const auto& [scheme, id, values] = GetParam();
  const Scene scene = scene_of(id, values);
  const bool third_order = scheme == "radau_exponentials";
  for (const double accuracy : {1e-3, third_order ? 1e-7 : 1e-5}) {
    const auto path = find_scheme(scheme)->solve(scene.problem, Accuracy{accuracy, accuracy}, {});
    ASSERT_EQ(path.ending, Ending::finished) << accuracy;
    EXPECT_EQ(path.reached, scene.problem.end);
    EXPECT_EQ(path.steps, std::ssize(path.times) - 1);
    EXPECT_TRUE(path.cost.rejected_steps);
    EXPECT_LT(largest_error(scene, path), 3.0 * accuracy) << accuracy;
  }
}

std::vector<Asked> smooth_and_singular() {
  std::vector<Asked> all;
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc", "radau_exponentials"}) {
    for (const auto* scene : {"relaxation", "diethelm", "linear_system", "fractional_oscillator", "pendulum",
                              "bagley_torvik", "damped_oscillator"})
      all.push_back({scheme, scene});
    all.push_back({scheme, "relaxation", {{"gamma", 0.1}}});
    all.push_back({scheme, "relaxation", {{"gamma", 1.7}}});
    all.push_back({scheme, "power", {{"gamma", 0.2}, {"p", 0.3}}});
  }
  return all;
}

// Stiff, with constraints, and with sparse derivatives.
std::vector<Asked> hard() {
  const auto multiplier = [](const char* scene) {
    return Asked{"radau_exponentials", scene, {{"formulation", "multiplier"}}};
  };
  return {{"adaptive_trapezoidal", "stiff_relaxation"},
          {"radau_exponentials", "stiff_relaxation", {{"lambda", -1e8}}},
          {"radau_exponentials", "brusselator"},
          {"radau_exponentials", "van_der_pol", {{"mu", 1e4}}},
          {"radau_exponentials", "robertson"},
          {"adaptive_trapezoidal", "fractional_diffusion"},
          {"radau_exponentials", "fractional_diffusion"},
          {"radau_exponentials", "nonlinear_fractional_oscillator", {{"form", "multiplier"}}},
          multiplier("nonholonomic_particle"),
          multiplier("loxodrome"),
          multiplier("isokinetic"),
          multiplier("fractional_knife_edge"),
          multiplier("fractional_constraint_2d"),
          multiplier("fractional_constraint_nonlinear")};
}

constexpr auto name_of = [](const auto& test) {
  auto name = testing::PrintToString(test.param);
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
};

INSTANTIATE_TEST_SUITE_P(Scenes, Adaptive, testing::ValuesIn(smooth_and_singular()), name_of);
INSTANTIATE_TEST_SUITE_P(HardScenes, Adaptive, testing::ValuesIn(hard()), name_of);

// D^0.5 y = t^p from 0 is Gamma(p+1)/Gamma(p+1.5) t^(p+0.5).
TEST(AdaptiveRules, AreExactForTheirPolynomials) {
  const auto error_of = [](const char* scheme, double p) {
    const Problem problem{.components = {{0.5, {0.0}}},
                          .rhs = [=](double t, In, Out f) { f[0] = std::pow(t, p); }};
    const auto path = find_scheme(scheme)->solve(problem, Accuracy{1e-4, 1e-4}, {.at = {1.0}});
    return std::abs(path.y(0, 0) - std::tgamma(p + 1.0) / std::tgamma(p + 1.5));
  };
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc"}) {
    EXPECT_LT(error_of(scheme, 1.0), 1e-14) << scheme;
    EXPECT_GT(error_of(scheme, 2.0), 1e-9) << scheme;
  }
  EXPECT_LT(error_of("radau_exponentials", 2.0), 1e-14);
  EXPECT_GT(error_of("radau_exponentials", 3.0), 1e-12);
}

// Errors of y' = -y fall with the square of the steps, those of Radau's rule with their fourth power, as the
// estimate that it goes by does.
TEST(AdaptiveRules, TakeAsManyStepsAsTheirRateSays) {
  const Problem problem{
      .components = {{1.0, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }, .end = 10.0};
  const auto more_steps = [&](const char* scheme) {
    const auto steps = [&](double accuracy) {
      return static_cast<double>(find_scheme(scheme)->solve(problem, Accuracy{accuracy, accuracy}, {}).steps);
    };
    return steps(1e-8) / steps(1e-6);
  };
  EXPECT_NEAR(more_steps("adaptive_trapezoidal"), 10.0, 1.0);
  EXPECT_NEAR(more_steps("adaptive_pc"), 10.0, 1.0);
  EXPECT_NEAR(more_steps("radau_exponentials"), std::sqrt(10.0), 0.3);
}

TEST(AdaptiveMemory, DoesNotGrowWithTheSteps) {
  const Scene scene = scene_of("brusselator");
  const auto bytes = [&](const char* scheme, double accuracy) {
    const auto path = find_scheme(scheme)->solve(scene.problem, Accuracy{accuracy, accuracy}, {});
    return static_cast<double>(path.cost.history_bytes.value());
  };
  for (const auto* scheme : {"adaptive_trapezoidal", "radau_exponentials"})
    EXPECT_LT(bytes(scheme, 1e-5), 1.2 * bytes(scheme, 1e-3)) << scheme;
}

// The error that D^0.5 y = -1e6 y leaves is a part of what is left of y, not of y(0).
TEST(AdaptiveStiff, KeepsTheDigitsOfWhatIsLeft) {
  const Scene scene = scene_of("stiff_relaxation");
  const double exact = mittag_leffler(0.5, 1.0, -1e6);
  for (const auto* scheme : {"adaptive_trapezoidal", "radau_exponentials"}) {
    const auto path = find_scheme(scheme)->solve(scene.problem, Accuracy{1e-4, 1e-300}, {.at = {1.0}});
    EXPECT_NEAR(path.y(0, 0) / exact, 1.0, 1e-4) << scheme;
  }
}

// y' = -1 from 1 leaves y > 0 at 1.
TEST(AdaptiveEnd, IsLocatedWhereTheDomainEnds) {
  Problem problem{.components = {{1.0, {1.0}}}, .rhs = [](double, In, Out f) { f[0] = -1.0; }, .end = 3.0};
  problem.domain = {"y = 0", [](double, In y) { return y[0]; }};
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc", "radau_exponentials"}) {
    const auto path = find_scheme(scheme)->solve(problem, Accuracy{1e-3, 1e-3}, {});
    EXPECT_EQ(path.ending, Ending::singular) << scheme;
    EXPECT_NEAR(path.reached, 1.0, 1e-14) << scheme;
  }
}

// D^0.5 y = 1, and -1 where y > 1: at y = 1 neither side leads away from it.
TEST(AdaptiveEnd, IsWhereARunSlidesAlongASwitch) {
  const Problem problem{.components = {{0.5, {0.0}}},
                        .rhs = [](double, In y, Out f) { f[0] = y[0] > 1.0 ? -1.0 : 1.0; },
                        .end = 2.0,
                        .switches = {[](double, In y) { return y[0] - 1.0; }}};
  for (const auto* scheme : {"adaptive_trapezoidal", "adaptive_pc", "radau_exponentials"}) {
    const auto path = find_scheme(scheme)->solve(problem, Accuracy{1e-4, 1e-4}, {.budget = 20.0});
    EXPECT_EQ(path.ending, Ending::not_converged) << scheme;
    EXPECT_NEAR(path.reached, M_PI / 4.0, 1e-3) << scheme;
  }
}

TEST(StepControl, TakesStepsWithAnErrorOfAtMostWhatIsAllowed) {
  StepControl control(2.0, 1.0);
  EXPECT_TRUE(control.judge(1.0, 1.0));
  EXPECT_FALSE(control.judge(1.01, 1.0));
  EXPECT_FALSE(control.judge(std::nan(""), 1.0));
}

TEST(StepControl, AimsBelowWhatIsAllowed) {
  StepControl control(2.0, 1.0);
  control.judge(4.0, 1.0);  // the error of half the step would be 1
  EXPECT_DOUBLE_EQ(control.length(), 0.4);
  control.judge(std::numeric_limits<double>::infinity(), 0.4);
  EXPECT_DOUBLE_EQ(control.length(), 0.1);
}

TEST(StepControl, KeepsALengthThatMayHardlyGrow) {
  StepControl control(2.0, 1.0);
  control.judge(0.5, 1.0);
  EXPECT_EQ(control.length(), 1.0);
}

TEST(StepControl, DoesNotGrowRightAfterARejection) {
  StepControl control(2.0, 1.0);
  control.judge(2.0, 1.0);
  const double length = control.length();
  control.judge(1e-6, length);
  EXPECT_EQ(control.length(), length);
  control.judge(1e-6, length);
  EXPECT_EQ(control.length(), 4.0 * length);
}

}  // namespace
}  // namespace fde
