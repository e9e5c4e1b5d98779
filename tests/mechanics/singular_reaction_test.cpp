// A reaction like t^-alpha whose direction turns, alpha >= 1/2: fractional_constraint_nonlinear with its
// multiplier, against power series in t^(1/10), 300 terms in 60 digits, that no code here has a part in.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/implicit_schemes.hpp"

namespace fde {
namespace {

struct SeriesValue {
  double alpha, t;
  Vec columns;  // q1, q2, v1, v2, w1, w2
};

const std::vector<SeriesValue>& series_values() {
  static const std::vector<SeriesValue> all{
      {0.6, 0.15,
       Vec{{1.0604863225993711, 0.12037310490475161, 0.23850362183156704, 0.8373722033962794,
            0.17533129831642221, 0.43157535894571148}}},
      {0.7, 0.1,
       Vec{{1.0444002147467908, 0.077055472394450473, 0.33277207584177072, 0.79788430864886852,
            0.21427468717729737, 0.43836889175877962}}},
      {0.8, 0.08,
       Vec{{1.0358442018655142, 0.059287907487212871, 0.3598067339586779, 0.76592417899851525,
            0.2555817853613109, 0.49770643976012992}}}};
  return all;
}

class SingularReaction : public testing::TestWithParam<std::tuple<const Scheme*, double, SeriesValue>> {};

TEST_P(SingularReaction, SchemesComeNearerToItsPowerSeries) {
  const auto& [scheme, grading, exact] = GetParam();
  const Scene scene =
      scene_of("fractional_constraint_nonlinear", {{"alpha", exact.alpha}, {"formulation", "multiplier"}});
  if (refusal(*scheme, scene.problem, Grid{exact.t, 64, grading})) GTEST_SKIP();
  std::vector<double> errors;
  for (const int steps : {64, 256, 1024}) {
    const auto path = scheme->solve(scene.problem, Grid{exact.t, steps, grading}, {.at = {exact.t}});
    ASSERT_EQ(path.ending, Ending::finished);
    errors.push_back(
        (columns_at(scene.outputs, exact.t, path.y.rightCols<1>()) - exact.columns).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(errors[1], errors[0] / 2.0);
  EXPECT_LT(errors[2], errors[1] / 2.0);
  EXPECT_LT(errors[2], 2e-3);
  if (scheme->id == "product_trapezoidal" && grading > 1.0) {
    EXPECT_LT(errors[2], 2e-7);
  }
}

std::string name_of_case(const testing::TestParamInfo<SingularReaction::ParamType>& test) {
  const auto& [scheme, grading, exact] = test.param;
  return fmt::format("{}__{}__{}", scheme->id, grading, std::lround(100.0 * exact.alpha));
}

INSTANTIATE_TEST_SUITE_P(, SingularReaction,
                         testing::Combine(testing::ValuesIn(implicit_schemes()),
                                          testing::Values(1.0, 2.0, 3.0, 4.0),
                                          testing::ValuesIn(series_values())),
                         name_of_case);

}  // namespace
}  // namespace fde
