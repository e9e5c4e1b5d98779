// SPDX-License-Identifier: MIT
// Statements about every mechanical file, for systems drawn at random: the formulations have the same motion,
// the right-hand sides have the given derivatives, and the energy changes by the given power.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "benchmarks/mechanics/mechanical_files_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// A system in which f = a(q).v + b(q).w - C holds at the start, where w = 0.
struct DrawnKind {
  std::size_t coordinates = 3, constraints = 1;
  std::vector<double> orders{};   // of the memory terms of the constraints
  bool is_constant = false;       // whether the metric and the constraints do not depend on q
  bool constraint_moves = false;  // whether t occurs in the constraints
};

class DrawnSystems {
 public:
  explicit DrawnSystems(unsigned seed) : generator_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  Vec some(Eigen::Index size, double low = -1.0, double high = 1.0) {
    return Vec::NullaryExpr(size, [&] { return between(low, high); });
  }

  // L = 1/2 sum m_i(q) v_i^2 + c v_1 v_2 - u(q) with a positive definite metric, and D^0.4 of all coordinates
  // as friction.
  WrittenSystem system(const DrawnKind& kind) {
    const std::vector<std::string> names{"x", "y", "z"};
    WrittenSystem drawn{.coordinates = {names.begin(), names.begin() + static_cast<long>(kind.coordinates)}};
    std::vector<std::string> terms;
    for (std::size_t i = 0; i < kind.coordinates; ++i) {
      const auto& q = drawn.coordinates[i];
      drawn.position.push_back(between(-1.0, 1.0));
      drawn.velocity.push_back(between(-1.0, 1.0));
      const double swing = kind.is_constant ? 0.0 : between(0.1, 0.3);
      const auto& other = drawn.coordinates[(i + 1) % kind.coordinates];
      terms.push_back(
          fmt::format("({} + {}*cos({} + {}))*D({},1)^2/2", between(0.8, 2.0), swing, q, other, q));
      terms.push_back(
          fmt::format("- {}*{}^2/2 - {}*cos({} - {})", between(0.5, 2.0), q, between(0.1, 0.5), q, other));
      drawn.forces.push_back(fmt::format("-{}*D({},0.4)", between(0.1, 0.5), q));
    }
    drawn.lagrangian = fmt::format("{} + {}*D(x,1)*D(y,1)", fmt::join(terms, " + "), between(-0.2, 0.2));
    for (std::size_t j = 0; j < kind.constraints; ++j)
      drawn.constraints.push_back(constraint(drawn, kind, j));
    return drawn;
  }

 private:
  // The diagonal entries of df/dv are the largest, so that the constraints are independent.
  std::string constraint(const WrittenSystem& of, const DrawnKind& kind, std::size_t j) {
    std::vector<std::string> terms, at_start;
    for (std::size_t i = 0; i < kind.coordinates; ++i) {
      const auto next = (i + 1) % kind.coordinates;
      const double weight = i == j ? between(1.5, 2.0) : between(-0.6, 0.6);
      const double swing = kind.is_constant ? 0.0 : between(0.1, 0.3);
      const auto factor = [&](const std::string& q) {
        return fmt::format("({} + {}*sin({}))", weight, swing, q);
      };
      terms.push_back(fmt::format("{}*D({},1)", factor(of.coordinates[next]), of.coordinates[i]));
      at_start.push_back(
          fmt::format("{}*({})", factor(fmt::format("({})", of.position[next])), of.velocity[i]));
    }
    for (const double order : kind.orders) {
      for (const auto& q : of.coordinates) {
        const double swing = kind.is_constant ? 0.0 : between(0.1, 0.3);
        terms.push_back(fmt::format("({} + {}*cos({}))*D({},{})", between(-0.8, 0.8), swing, q, q, order));
      }
    }
    if (kind.constraint_moves) terms.push_back(fmt::format("{}*sin(t)*x", between(0.2, 0.5)));
    return fmt::format("{} - ({})", fmt::join(terms, " + "), fmt::join(at_start, " + "));
  }

  std::mt19937 generator_;
};

const std::vector<DrawnKind> kinds{{.coordinates = 2},
                                   {.coordinates = 3, .constraint_moves = true},
                                   {.coordinates = 3, .constraints = 2},
                                   {.coordinates = 2, .orders = {0.3}},
                                   {.coordinates = 3, .orders = {0.2, 0.45}, .constraint_moves = true},
                                   {.coordinates = 3, .constraints = 2, .orders = {0.3, 0.7}}};

Scene posed_as(const std::string& file, const std::string& formulation) {
  return make_scene_unchecked(equation_scene(parse_equation_text("test.toml", file)),
                              {{"formulation", formulation}, {"kappa", 3.0}});
}

Vec rate_of(const Scene& scene, double t, const Vec& y) {
  Vec f(y.size());
  scene.problem.rhs(t, y, f);
  return f;
}

// The columns, followed by the multipliers of the scene at these rates w' of its memory terms: a state of the
// multiplier form.
Vec state_with_multipliers(const Scene& multiplier_form, double t, const Vec& columns, const Vec& rates) {
  const auto& reactions = multiplier_form.reactions;
  Vec lambda(multiplier_form.constraint.size), y(multiplier_form.problem.size());
  reactions.multipliers(t, columns, rates, lambda);
  y << columns, lambda;
  return y;
}

// The motion of the columns at one time: their values and their rates, w' being free.
struct MovingColumns {
  Vec columns, rates;
};

// At any columns q, v, w and rates w' of the memory terms of the constraints.
MovingColumns motion_at(const Scene& multiplier_form, double t, const Vec& columns, const Vec& memory_rates) {
  const Vec f =
      rate_of(multiplier_form, t, state_with_multipliers(multiplier_form, t, columns, memory_rates));
  const auto n = std::ssize(multiplier_form.geometry.coordinates);
  Vec rates = Vec::Zero(columns.size());
  rates.head(2 * n) = f.head(2 * n);
  const auto& moving = multiplier_form.reactions.differentiated_columns;
  for (std::size_t k = 0; k < moving.size(); ++k)
    rates[moving[k]] = memory_rates[static_cast<Eigen::Index>(k)];
  return {columns, rates};
}

// d/dt of a function of t and the columns, or of a state, that move with these rates, by differences.
template <class Function>
Vec rate_along(const Function& function, double t, const Vec& y, const Vec& rates) {
  constexpr double h = 1e-5;
  const Vec above = function(t + h, y + h * rates), below = function(t - h, y - h * rates);
  return (above - below) / (2 * h);
}

// The multipliers keep df/dt = 0 whatever the rates w' of the memory terms are.
TEST(DrawnMotions, StayOnTheirConstraints) {
  DrawnSystems draw(1);
  for (const auto& kind : kinds) {
    const Scene scene = posed_as(mechanical_file_of(draw.system(kind)), "multiplier");
    const Vec memory_rates = draw.some(std::ssize(scene.reactions.differentiated_columns));
    EXPECT_EQ(memory_rates.size(), std::ssize(kind.orders) * static_cast<Eigen::Index>(kind.coordinates));
    const auto [columns, rates] =
        motion_at(scene, 0.3, draw.some(std::ssize(scene.outputs.names)), memory_rates);
    const auto f = [&](double t, const Vec& at) {
      Vec value(scene.constraint.size);
      scene.constraint.value(t, at, value);
      return value;
    };
    EXPECT_LT(rate_along(f, 0.3, columns, rates).norm(), 1e-8);
  }
}

// The velocities of the integrated form move with the reaction that keeps df/dt = 0. A state of this form is
// on the constraint with v - v(z = 0) in place of z, which is P z.
TEST(DrawnMotions, HaveOneAccelerationWithoutMemoryInTheConstraints) {
  DrawnSystems draw(2);
  for (const auto& kind : kinds) {
    if (!kind.orders.empty()) continue;
    const std::string file = mechanical_file_of(draw.system(kind));
    const Scene integrated = posed_as(file, "integrated"), multiplier = posed_as(file, "multiplier"),
                acceleration = posed_as(file, "acceleration"), stabilised = posed_as(file, "stabilised");
    const auto n = static_cast<Eigen::Index>(kind.coordinates);
    constexpr double t = 0.3;
    Vec y = draw.some(integrated.problem.size()), resting = y;
    resting.segment(n, n).setZero();
    const auto velocity = [&](double at, const Vec& state) -> Vec {
      return columns_at(integrated.outputs, at, state).segment(n, n);
    };
    y.segment(n, n) = velocity(t, y) - velocity(t, resting);
    const Vec columns = columns_at(integrated.outputs, t, y);
    EXPECT_LT(integrated.constraint.drift(t, columns), 1e-14);
    Vec f = rate_of(integrated, t, y);
    f.tail(n).setZero();  // D^0.6 w is no rate; v does not depend on w
    const Vec expected = motion_at(multiplier, t, columns, Vec()).rates.segment(n, n);
    EXPECT_LT((rate_along(velocity, t, y, f) - expected).norm(), 1e-8);
    for (const auto* form : {&acceleration, &stabilised})
      EXPECT_LT((rate_of(*form, t, columns).segment(n, n) - expected).norm(), 1e-12);
  }
}

// df/dy of every formulation that is well posed, by differences.
TEST(DrawnMotions, HaveTheJacobiansOfTheirRightHandSides) {
  DrawnSystems draw(3);
  int tested = 0;
  for (const auto& kind : kinds) {
    const std::string file = mechanical_file_of(draw.system(kind));
    for (const auto* formulation : {"integrated", "acceleration", "stabilised", "multiplier"}) {
      const Scene scene = posed_as(file, formulation);
      if (!scene.ill_posed_reason.empty()) continue;
      ++tested;
      const auto size = scene.problem.size();
      const Vec y = draw.some(size);
      Matrix jacobian(size, size);
      ASSERT_TRUE(evaluate_jacobian(scene.problem, 0.3, y, jacobian));
      for (Eigen::Index j = 0; j < size; ++j) {
        const auto rhs = [&](double, const Vec& at) { return rate_of(scene, 0.3, at); };
        const Vec column = rate_along(rhs, 0.3, y, Vec::Unit(size, j));
        EXPECT_LT((jacobian.col(j) - column).norm(), 1e-8 * (1.0 + column.norm())) << formulation << ' ' << j;
      }
    }
  }
  EXPECT_EQ(tested, 22);  // with the order 0.7 v' cannot be posed
}

// dE/dt = power + sum_k c_k w_k', whatever the rates w' are.
TEST(DrawnMotions, ChangeTheirEnergyByItsPower) {
  DrawnSystems draw(4);
  for (const auto& kind : kinds) {
    const Scene scene = posed_as(mechanical_file_of(draw.system(kind)), "multiplier");
    const Energy& energy = scene.energy;
    const Vec memory_rates = draw.some(std::ssize(scene.reactions.differentiated_columns));
    const auto [columns, rates] =
        motion_at(scene, 0.3, draw.some(std::ssize(scene.outputs.names)), memory_rates);
    const auto value = [&](double, const Vec& at) { return Vec::Constant(1, energy.value(at)).eval(); };
    double power = energy.power(0.3, columns);
    EXPECT_EQ(energy.differentiated_columns, scene.reactions.differentiated_columns);
    if (!kind.orders.empty()) {
      Vec shares(memory_rates.size());
      energy.rate_coefficients(0.3, columns, shares);
      power += shares.dot(memory_rates);
    }
    EXPECT_NEAR(rate_along(value, 0.3, columns, rates)[0], power, 1e-8);
  }
}

// The power is F.v of the forces plus that of the reactions.
TEST(DrawnMotions, HaveThePowerOfForcesAndReactions) {
  DrawnSystems draw(5);
  for (const auto& kind : kinds) {
    if (!kind.orders.empty()) continue;
    WrittenSystem system = draw.system(kind);
    const Scene with = posed_as(mechanical_file_of(system), "multiplier");
    const auto n = static_cast<Eigen::Index>(kind.coordinates);
    const Vec columns = draw.some(std::ssize(with.outputs.names));
    const DynamicsOfFile motion(mechanical_file_of(system));
    const Vec forces = motion.values(motion.system.forces, 0.3, {columns});
    const Vec lambda = state_with_multipliers(with, 0.3, columns, Vec()).tail(with.constraint.size);
    const double power = forces.dot(columns.segment(n, n)) + with.reactions.power(0.3, columns, lambda);
    EXPECT_NEAR(with.energy.power(0.3, columns), power, 1e-13);
  }
}

// Constant constraints with two orders: the multiplier is eliminated from the discretisation too.
TEST(DrawnMotions, AreTheSameStepsWithAndWithoutAMultiplier) {
  DrawnSystems draw(6);
  for (const auto& [coordinates, constraints] : {std::pair{2, 1}, {3, 1}, {3, 2}}) {
    const std::string file =
        mechanical_file_of(draw.system({.coordinates = static_cast<std::size_t>(coordinates),
                                        .constraints = static_cast<std::size_t>(constraints),
                                        .orders = {0.35, 0.8},
                                        .is_constant = true}));
    const auto path = [&](const std::string& formulation) {
      const Scene scene = posed_as(file, formulation);
      return columns_of(scene.outputs, solve("product_trapezoidal", scene.problem, 200));
    };
    EXPECT_LT((path("integrated") - path("multiplier")).cwiseAbs().maxCoeff(), 1e-10);
  }
}

// Errors name the file, the line and the column in one line.

WrittenSystem two_masses(const std::vector<std::string>& constraints) {
  return {.coordinates = {"x", "y"},
          .position = {0.0, 0.0},
          .velocity = {1.0, 0.0},
          .lagrangian = "(D(x,1)^2 + D(y,1)^2)/2",
          .constraints = constraints};
}

std::string error_of(const std::string& file) {
  return message_of<std::invalid_argument>([&] { scene_of_mechanical_file(file); });
}

void expect_error(const std::string& file, int line, const std::string& part) {
  const std::string error = error_of(file);
  EXPECT_TRUE(error.starts_with(fmt::format("test.toml: line {}, column ", line))) << error;
  EXPECT_NE(error.find(part), std::string::npos) << error;
  EXPECT_EQ(std::ranges::count(error, '\n'), 0) << error;
}

// f = x' + 2 y' - 1/2 is 1/2 at v = (1, 0); the nearest velocity in the metric G is
// v - f G^-1 a / (a G^-1 a).
TEST(MechanicalFileErrors, NameTheNearestVelocityOnTheConstraint) {
  auto system = two_masses({"D(x,1) + 2*D(y,1) - 0.5"});
  expect_error(mechanical_file_of(system), 8,
               "is 0.5 at t = 0: must be 0 with these initial values; the nearest velocity with this is "
               "D(x,1) = 0.9, D(y,1) = -0.2");
  system.lagrangian = "(D(x,1)^2 + 4*D(y,1)^2)/2";
  expect_error(mechanical_file_of(system), 8, "D(x,1) = 0.75, D(y,1) = -0.125");
}

TEST(MechanicalFileErrors, NameASingularMetric) {
  auto system = two_masses({});
  for (const auto* lagrangian : {"D(x,1)^2/2 - y^2", "x*D(x,1)^2 + D(y,1)^2", "(D(x,1) + D(y,1))^2"}) {
    system.lagrangian = lagrangian;
    expect_error(mechanical_file_of(system), 7, "a singular matrix at t = 0");
    system.constraints = {"D(x,1) - 1"};
    expect_error(mechanical_file_of(system), 7, "a singular matrix at t = 0");
  }
}

TEST(MechanicalFileErrors, NameDependentConstraints) {
  WrittenSystem system{.coordinates = {"x", "y", "z"},
                       .position = {0.0, 0.0, 0.0},
                       .velocity = {1.0, 1.0, 0.0},
                       .lagrangian = "(D(x,1)^2 + D(y,1)^2 + D(z,1)^2)/2",
                       .constraints = {"D(x,1) - D(y,1)", "2*D(x,1) - 2*D(y,1)"}};
  expect_error(mechanical_file_of(system), 10, "depends on the constraints before it at t = 0");
  system.constraints[1] = "(2 + x)*(D(x,1) - D(y,1)) + z*D(z,1)";
  expect_error(mechanical_file_of(system), 10, "depends on the constraints before it at t = 0");
}

TEST(MechanicalFileErrors, NameAConstraintWithoutVelocity) {
  for (const auto* constraint : {"x - y", "D(x,0.5) - D(y,0.5)", "x*D(y,1)"})
    expect_error(mechanical_file_of(two_masses({constraint})), 8, "does not depend on a velocity at t = 0");
}

TEST(MechanicalFileErrors, NameAFormulationThatDoesNotExist) {
  const std::string file = mechanical_file_of(two_masses({"D(x,1)^2 + D(y,1)^2 - 1"}));
  expect_error(
      file + "formulation = \"integrated\"\n", 8,
      "formulation = integrated: must not be integrated, this constraint is not affine in the velocity");
  EXPECT_EQ(error_of(file + "formulation = \"multiplier\"\n"), "accepted");
  expect_error(file + "formulation = \"other\"\n", 9,
               "formulation = other: must be one of integrated, acceleration, stabilised, multiplier");
  expect_error(mechanical_file_of(two_masses({}), "formulation = \"multiplier\"\n"), 8,
               "formulation = multiplier: there must be constraints");
}

TEST(MechanicalFileErrors, NameMoreConstraintsThanCoordinates) {
  expect_error(mechanical_file_of(two_masses({"D(x,1) - 1", "D(y,1)"})), 8,
               "there are 2 constraints: must be fewer than the 2 coordinates");
}

TEST(MechanicalFileErrors, NameUnknownKeys) {
  const std::string file = mechanical_file_of(two_masses({}));
  expect_error(file + "lagrange = \"x\"\n", 8, "lagrange");
  expect_error(file + "forces.z = \"1\"\n", 8, "forces z: must be the name of a coordinate");
  expect_error(file + "principle = \"least\"\n", 8, "principle = least: must be one of dalembert, vakonomic");
  expect_error("end = 1\n[coordinate.x]\nstart = [0, 0]\n[mechanics]\nlagrangian = \"D(x,1)^2\"\n", 3,
               "start");
}

}  // namespace
}  // namespace fde::bench
