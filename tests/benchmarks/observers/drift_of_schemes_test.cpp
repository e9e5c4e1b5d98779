// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/observers/independent_memory.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

Scene constrained(double alpha, const std::string& formulation = "integrated") {
  return scene_of("fractional_constraint_2d", {{"alpha", alpha}, {"formulation", formulation}});
}

struct Drifts {
  Drift internal;
  std::optional<Drift> independent;
};

// The drifts of a run of a scheme.
Drifts drifts_of(const Scene& scene, std::string_view scheme, int steps) {
  DriftObserver watch(scene, Grid{scene.problem.end, steps});
  Options options{.output_times = {scene.problem.end}};
  options.observer = [&](double t, In y) { watch.observe(t, columns_at(scene.outputs, t, y)); };
  solve(scheme, scene.problem, steps, options);
  return {watch.internal(), watch.independent()};
}

// A path that satisfies the constraint v + w = 0: v = 1 and w = -1, while D^(1/2) q is 2 sqrt(t/pi).
Scene manufactured_drift_scene() {
  Scene scene;
  scene.problem.end = 4.0;
  scene.outputs.names = {"q", "v", "w"};
  scene.constraint = {1, [](double, In columns, Out f) { f[0] = columns[1] + columns[2]; }};
  scene.memory_columns = {{2, 1, 0.5, {}}};
  return scene;
}

TEST(DriftObserver, TellsWhatTheSchemeSaysFromWhatItsVelocitiesSay) {
  const Scene scene = manufactured_drift_scene();
  const Grid grid{.end = scene.problem.end, .steps = 1000};
  DriftObserver watch(scene, grid);
  for (int n = 0; n <= grid.steps; ++n)
    watch.observe(grid.time(n), Vec{{grid.time(n), 1.0, n == 333 ? -1.5 : -1.0}});
  EXPECT_EQ(watch.internal().largest, 0.5);  // at step 333 only: every step is evaluated
  EXPECT_NEAR(watch.independent()->largest, 1.0 + 4.0 / std::sqrt(std::acos(-1.0)), 1e-13);
  EXPECT_TRUE(watch.internal().course.empty()) << "the independent drift has one";
  EXPECT_NEAR(watch.independent()->course.value.back(), watch.independent()->largest, 5e-3);
}

bool has_independent_drift(const Scene& scene, const std::optional<Grid>& grid, const Grid& seen) {
  DriftObserver watch(scene, grid);
  for (int n = 0; n <= seen.steps; ++n) watch.observe(seen.time(n), Vec{{seen.time(n), 1.0, -1.0}});
  return watch.independent().has_value();
}

TEST(DriftObserver, HasAnIndependentDriftWithMemoriesAndTheStepsOfAUniformGrid) {
  Scene scene = manufactured_drift_scene();
  const Grid grid{.end = 4.0, .steps = 64}, few{.end = 4.0, .steps = 15}, graded{4.0, 64, 2.0}, more{4.0, 65};
  EXPECT_TRUE(has_independent_drift(scene, grid, grid));
  EXPECT_FALSE(has_independent_drift(scene, few, few));
  EXPECT_FALSE(has_independent_drift(scene, graded, graded));
  EXPECT_FALSE(has_independent_drift(scene, grid, more));
  EXPECT_FALSE(has_independent_drift(scene, std::nullopt, grid));
  scene.memory_columns.clear();
  EXPECT_FALSE(has_independent_drift(scene, grid, grid));
}

// The error of IndependentMemoryRule for the exact velocities.
double error_of_memory_rule(const Scene& scene, const Rows& exact, const Grid& grid) {
  const IndependentMemoryRule memory(grid, scene.memory_columns[0].order, scene.memory_columns[0].powers);
  double largest = 0.0;
  for (int n = 1; n <= grid.steps; ++n)
    largest = std::max(largest, std::abs(memory.at(n, exact.row(2)) - exact(4, n)));
  return largest;
}

Rows exact_columns(const Scene& scene, const Grid& grid) {
  const reference::Reference reference = reference_of(scene);
  Rows exact(6, grid.steps + 1);
  for (int n = 0; n <= grid.steps; ++n) exact.col(n) = reference.at(grid.time(n)).value;
  return exact;
}

// IndependentMemoryRule is much more accurate than the schemes: for the exact velocities its error in w is
// far below the errors of w in the schemes.
TEST(IndependentMemoryRule, IsFarBelowTheErrorsOfTheSchemes) {
  for (const double alpha : {0.3, 0.5, 0.8}) {
    const Scene scene = constrained(alpha);
    const Grid grid{scene.problem.end, 512};
    const Rows exact = exact_columns(scene, grid);
    const double judge = error_of_memory_rule(scene, exact, grid);
    for (const auto* scheme : {"adams_pc", "product_trapezoidal", "l1", "grunwald_letnikov"}) {
      const auto path = solve(scheme, scene.problem, grid.steps);
      const double error = (columns_of(scene.outputs, path).row(4) - exact.row(4)).cwiseAbs().maxCoeff();
      RecordProperty("ratio_" + std::to_string(int(100 * alpha)) + "_" + scheme,
                     std::to_string(error / judge));
      EXPECT_GT(error, 50.0 * judge) << "alpha = " << alpha << ", " << scheme << ", " << error << " "
                                     << judge;
    }
  }
}

// a.z = C0 is linear, and every scheme conserves it for any w.
TEST(Drift, OfTheIntegratedFormIsInternallyRounding) {
  for (const double alpha : {0.3, 0.5, 0.8}) {
    const Scene scene = constrained(alpha);
    for (const auto* scheme : row_schemes()) {
      const auto drift = drifts_of(scene, scheme->id, 1024).internal;
      EXPECT_LT(drift.largest, 1e-14) << scheme->id << " " << alpha;
      EXPECT_FALSE(drift.growth.has_value());
    }
  }
}

class IndependentDrift : public testing::TestWithParam<const Scheme*> {};

// The drift is the difference of w and D^alpha of the computed q: the quadrature error of the scheme, as long
// as it exceeds the error of IndependentMemoryRule.
TEST_P(IndependentDrift, FallsAtTheRateOfTheScheme) {
  const Scheme& scheme = *GetParam();
  const Scene scene = constrained(0.5);
  std::vector<ErrorSample> points;
  for (const int steps : {256, 512, 1024, 2048})
    points.push_back({scene.problem.end / steps, drifts_of(scene, scheme.id, steps).independent->largest});
  const double expected = scheme.expected_rate(scene.problem, scene.smoothness, 1.0, Norm::maximum);
  const Fit fit = fit_rate(points);
  EXPECT_GT(fit.correlation, 0.99);
  static const double judge = [&] {
    const Grid finest{scene.problem.end, 2048};
    return error_of_memory_rule(scene, exact_columns(scene, finest), finest);
  }();
  EXPECT_TRUE(fit.slope > expected - 0.15 || points.back().error < 2.0 * judge)
      << fit.slope << ' ' << points.back().error << ' ' << judge;
}

INSTANTIATE_TEST_SUITE_P(, IndependentDrift, testing::ValuesIn(row_schemes()), id_of_param);

TEST(Drift, OfTheAccelerationFormIsNotRoundingAndFallsWithTheStep) {
  const Scene scene = constrained(0.3, "acceleration");
  const auto coarse = drifts_of(scene, "product_trapezoidal", 512);
  const auto fine = drifts_of(scene, "product_trapezoidal", 1024);
  EXPECT_GT(fine.internal.largest, 1e-8);
  EXPECT_LT(fine.internal.largest, 0.7 * coarse.internal.largest);
  EXPECT_TRUE(fine.internal.growth.has_value());
}

TEST(Drift, IsRecordedWithItsGrowthAlsoWithoutAReference) {
  Scene scene = constrained(0.5);
  scene.reference.at = [](double) -> reference::ReferenceValue { throw std::runtime_error("none is known"); };
  MemoizedReference reference(scene);
  const auto run = examine({}, scene, reference, *find_scheme("l1"), {64});
  EXPECT_EQ(sentence(run.ending), "no reference: none is known");
  EXPECT_TRUE(run["drift_internal"]);
  EXPECT_TRUE(run["drift_independent"]);
  EXPECT_TRUE(run["drift_independent_growth"]);
  EXPECT_FALSE(run["drift_internal_growth"]);  // at the level of rounding
  EXPECT_FALSE(run["error_end"]);
}

}  // namespace
}  // namespace fde::bench
