// SPDX-License-Identifier: MIT
// Every formulation of every scene with a constraint has a correct df/dy of its nonlinear right-hand side.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <stdexcept>

#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct ConstraintForm {
  std::string name;
  ParameterValues values;
};

// Expands the forms by all choices of one parameter.
void choose(std::vector<ConstraintForm>& forms, const Parameter& parameter) {
  std::vector<ConstraintForm> chosen;
  for (const auto& form : forms) {
    for (const auto& word : parameter.choices) {
      ConstraintForm next = form;
      next.name += "_" + word;
      next.values[parameter.name] = word;
      chosen.push_back(next);
    }
  }
  if (!chosen.empty()) forms = chosen;
}

// Those of a scene with a constraint, of several orders where it has one; some may be refused.
std::vector<ConstraintForm> forms_of(const SceneFactory& factory) {
  std::vector<ConstraintForm> forms{{factory.id, {}}};
  for (const auto& parameter : factory.parameters) choose(forms, parameter);
  if (forms.size() == 1 && factory.id != "vakonomic_particle") return {};
  if (std::ranges::find(factory.parameters, "alpha", &Parameter::name) == factory.parameters.end())
    return forms;
  std::vector<ConstraintForm> of_orders;
  for (const auto& form : forms) {
    for (const double alpha : {0.3, 0.8, 1.0, 1.5}) {
      of_orders.push_back(form);
      of_orders.back().name += fmt::format(", alpha = {}", alpha);
      of_orders.back().values["alpha"] = alpha;
    }
  }
  return of_orders;
}

std::vector<const SceneFactory*> scenes_with_forms() {
  std::vector<const SceneFactory*> some;
  for (const auto& factory : built_in_scenes()) {
    if (!forms_of(factory).empty()) some.push_back(&factory);
  }
  return some;
}

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

void expect_right_jacobian(const Problem& problem) {
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

class FormsWithConstraint : public testing::TestWithParam<const SceneFactory*> {};

TEST_P(FormsWithConstraint, PassTheJacobianOfTheirRightHandSide) {
  int accepted = 0;
  for (const ConstraintForm& form : forms_of(*GetParam())) {
    SCOPED_TRACE(form.name);
    std::optional<Scene> scene;
    try {
      scene = scene_of(GetParam()->id, form.values);
    } catch (const std::invalid_argument&) {
      continue;
    }
    expect_right_jacobian(scene->problem);
    ++accepted;
  }
  EXPECT_TRUE(accepted > 0 || GetParam()->id == "multi_term");  // whose alpha is a list
}

INSTANTIATE_TEST_SUITE_P(, FormsWithConstraint, testing::ValuesIn(scenes_with_forms()), id_of_param);

}  // namespace
}  // namespace fde::bench
