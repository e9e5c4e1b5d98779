// SPDX-License-Identifier: MIT
// Every formulation of every scene with a constraint has a correct df/dy of its nonlinear right-hand side.

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <stdexcept>

#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct Form {
  std::string scene, name;  // name: of the test case
  ParameterValues values;
};

// Throws std::invalid_argument if the formulation is refused.
Problem problem_of(const Form& form) { return scene_of(form.scene, form.values).problem; }

// Expands the forms by all choices of one parameter.
void choose(std::vector<Form>& forms, const Parameter& parameter) {
  std::vector<Form> chosen;
  for (const auto& form : forms) {
    for (const auto& word : parameter.choices) {
      Form next = form;
      next.name += "_" + word;
      next.values[parameter.name] = word;
      chosen.push_back(next);
    }
  }
  if (!chosen.empty()) forms = chosen;
}

std::vector<Form> forms_with_constraints() {
  std::vector<Form> found;
  for (const auto& maker : built_in_scenes()) {
    std::vector<Form> forms{{maker.id, maker.id, {}}};
    for (const auto& parameter : maker.parameters) choose(forms, parameter);
    if (forms.size() == 1 && forms[0].scene != "vakonomic_particle") continue;
    for (const auto& form : forms) {
      for (const double alpha : {0.3, 0.8, 1.0, 1.5}) {
        const bool has_order =
            std::ranges::find(maker.parameters, "alpha", &Parameter::name) != maker.parameters.end();
        if (!has_order && alpha != 1.0) continue;
        Form next = form;
        if (has_order) {
          next.name += "_" + std::to_string(static_cast<int>(10 * alpha));
          next.values["alpha"] = alpha;
        }
        try {
          problem_of(next);
        } catch (const std::invalid_argument&) {
          continue;
        }
        found.push_back(next);
      }
    }
  }
  return found;
}

class FormWithConstraint : public testing::TestWithParam<Form> {};

// df/dy_column by differences of order 6.
Vec differenced(const Problem& problem, double t, const Vec& y, Eigen::Index column) {
  constexpr double h = 1e-3;
  constexpr std::array weights{45.0, -9.0, 1.0};
  Vec sum = Vec::Zero(y.size()), f(y.size());
  for (int k = 1; k <= 3; ++k) {
    for (const double side : {1.0, -1.0}) {
      Vec moved = y;
      moved[column] += side * k * h;
      problem.rhs(t, moved, f);
      sum += side * weights.at(static_cast<std::size_t>(k - 1)) * f;
    }
  }
  return sum / (60.0 * h);
}

TEST_P(FormWithConstraint, PassesTheJacobianOfItsRightHandSide) {
  const Problem problem = problem_of(GetParam());
  ASSERT_TRUE(has_jacobian(problem));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (const double t : {0.3, 0.9, 2.5}) {
    // The forcing of manufactured solutions contains powers of end - t.
    if (is_two_sided(problem) && t > problem.end) continue;
    const Vec y =
        taylor_part(problem, 0.0) + Vec::NullaryExpr(problem.size(), [&] { return uniform(generator); });
    Matrix jacobian(y.size(), y.size());
    evaluate_jacobian(problem, t, y, jacobian);
    for (Eigen::Index j = 0; j < y.size(); ++j) {
      const Vec column = differenced(problem, t, y, j);
      EXPECT_LT((jacobian.col(j) - column).norm(), 1e-11 * (1.0 + column.norm()))
          << "t = " << t << ", column " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, FormWithConstraint, testing::ValuesIn(forms_with_constraints()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace fde::bench
