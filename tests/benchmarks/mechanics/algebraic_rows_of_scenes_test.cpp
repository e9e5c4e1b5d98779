// SPDX-License-Identifier: MIT
// Every scene with algebraic rows, in every formulation, with every scheme, on grids of several gradings:
// either the error decreases with the number of steps, or the scheme refuses the problem.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// A motion up to an end: its name, scene and parameters without the formulation.
struct ConstrainedMotion {
  std::string name, scene;
  ParameterValues values;
  double end;
};

std::vector<ConstrainedMotion> motions() {
  std::vector<ConstrainedMotion> all{{"nonholonomic_particle", "nonholonomic_particle", {}, 2.0},
                                     {"knife_edge", "knife_edge", {}, 2.0},
                                     {"rolling_disc", "rolling_disc", {}, 2.0},
                                     {"loxodrome", "loxodrome", {}, 1.0},
                                     {"blade_on_sphere", "blade_on_sphere", {}, 2.0},
                                     {"canonical_ensemble", "canonical_ensemble", {}, 2.0},
                                     {"isobaric_ensemble", "isobaric_ensemble", {}, 2.0},
                                     {"isokinetic", "isokinetic", {}, 2.0}};
  const auto add = [&](const std::string& scene, double alpha, ParameterValues values = {}) {
    const auto percent = static_cast<int>(std::lround(100.0 * alpha));
    values["alpha"] = alpha;
    all.push_back({fmt::format("{}_{}", scene, percent), scene, values, 1.0});
  };
  for (const double alpha : {0.3, 0.5, 0.7, 0.9, 1.0}) add("fractional_constraint_2d", alpha);
  for (const double alpha : {1.3, 1.5, 1.7}) {
    add("fractional_constraint_2d", alpha, {{"b1", 0.6}, {"b2", 0.3}});  // a.b > 0: no growing mode
  }
  for (const double alpha : {0.3, 0.5, 0.7, 0.9, 1.0}) add("fractional_knife_edge", alpha);
  for (const double alpha : {0.2, 0.4, 0.5, 0.6, 0.7, 0.8}) add("fractional_constraint_nonlinear", alpha);
  return all;
}

const std::vector<std::string>& formulations() {
  static const std::vector<std::string> all{"integrated", "acceleration", "stabilised", "multiplier"};
  return all;
}

// The scene in this formulation; nullopt if the scene does not have it or refuses it.
std::optional<Scene> in_form(const ConstrainedMotion& motion, const std::string& formulation) {
  ParameterValues values = motion.values;
  values["formulation"] = formulation;
  try {
    return make_scene({.factory = &scene_factory(motion.scene), .values = values, .until = motion.end});
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// The columns at the end, computed once for all gradings.
const Vec& exact_end(const ConstrainedMotion& motion) {
  static std::map<std::string, Vec> known;
  if (!known.contains(motion.name))
    known[motion.name] = reference_of(*in_form(motion, "multiplier")).at(motion.end).value;
  return known[motion.name];
}

// The error of the last step, relative to 1 + |exact|; nullopt if the scheme refuses.
std::optional<double> error_of(const Scene& scene, const Scheme& scheme, const Grid& grid, const Vec& exact) {
  if (unsupported_reason(scheme, scene.problem, grid)) return std::nullopt;
  const auto path = scheme.solve(scene.problem, grid, {.output_times = {grid.end}});
  EXPECT_EQ(path.status, SolveStatus::finished);
  if (path.status != SolveStatus::finished) return std::nullopt;
  const Vec last = columns_at(scene.outputs, grid.end, path.y.rightCols<1>());
  return ((last - exact).array().abs() / (1.0 + exact.array().abs())).maxCoeff();
}

void expect_nearer_or_refused(const Scene& scene, const Scheme& scheme, double grading, const Vec& exact) {
  std::vector<double> errors;
  for (const int steps : {64, 256, 1024}) {
    if (const auto found = error_of(scene, scheme, {scene.problem.end, steps, grading}, exact))
      errors.push_back(*found);
  }
  if (errors.empty()) return;  // refused
  ASSERT_EQ(errors.size(), 3U);
  for (std::size_t k = 1; k < errors.size(); ++k)
    EXPECT_TRUE(errors[k] < errors[k - 1] / 2.0 || errors[k] < 1e-11) << k << ": " << errors[k];
  EXPECT_LT(errors.back(), 0.05);
}

class AlgebraicRowsOfScenes : public testing::TestWithParam<std::tuple<ConstrainedMotion, double>> {};

TEST_P(AlgebraicRowsOfScenes, ComeNearerToTheTruthOrAreRefused) {
  const auto& [motion, grading] = GetParam();
  const Vec& exact = exact_end(motion);
  for (const auto& formulation : formulations()) {
    const auto scene = in_form(motion, formulation);
    if (!scene) continue;
    for (const Scheme* scheme : row_schemes()) {
      SCOPED_TRACE(fmt::format("{} by {}", formulation, scheme->id));
      expect_nearer_or_refused(*scene, *scheme, grading, exact);
    }
  }
}

std::string name_of_case(const testing::TestParamInfo<AlgebraicRowsOfScenes::ParamType>& test) {
  const auto& [motion, grading] = test.param;
  return fmt::format("{}__{}", motion.name, grading);
}

INSTANTIATE_TEST_SUITE_P(, AlgebraicRowsOfScenes,
                         testing::Combine(testing::ValuesIn(motions()), testing::Values(1.0, 2.0, 3.0, 4.0)),
                         name_of_case);

// motions() has every scene with algebraic rows, and the schemes that support such rows accept the multiplier
// form.
TEST(ConstrainedMotions, AreOfAllScenesWithAlgebraicRows) {
  for (const SceneFactory& factory : built_in_scenes()) {
    const auto choice = std::ranges::find(factory.parameters, "formulation", &Parameter::name);
    const bool has = choice != factory.parameters.end();
    const auto all = motions();
    EXPECT_EQ(has, std::ranges::count(all, factory.id, &ConstrainedMotion::scene) > 0) << factory.id;
  }
  for (const auto& motion : motions()) {
    const Scene scene = *in_form(motion, "multiplier");
    ASSERT_TRUE(std::ranges::any_of(scene.problem.components, is_algebraic));
    for (const Scheme* scheme : row_schemes()) {
      const bool refused = unsupported_reason(*scheme, scene.problem, Grid{motion.end, 64}).has_value();
      EXPECT_EQ(refused, !scheme->capabilities.algebraic_rows) << motion.name << ' ' << scheme->id;
    }
  }
}

}  // namespace
}  // namespace fde::bench
