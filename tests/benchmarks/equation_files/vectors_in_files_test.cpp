// SPDX-License-Identifier: MIT
// Vectors of unknowns in equation files: each is its components written out, and a field is that of a scene.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/message_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// A vector u with these further keys, and what follows.
std::string vector_file(const std::string& keys, const std::string& rest = "") {
  return "end = 1\n[parameters]\nk = 0.7\n[unknown.u]\n" + keys + rest;
}

// y of the problem that differs from row to row.
Vec some_state(Eigen::Index size) { return Vec::LinSpaced(size, 0.3, 1.7).array().cos(); }

void expect_same(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.problem.size(), b.problem.size());
  EXPECT_EQ(a.outputs.names, b.outputs.names);
  const Vec y = some_state(a.problem.size());
  EXPECT_EQ(rhs_at(a.problem, 0.4, y), rhs_at(b.problem, 0.4, y));
  EXPECT_EQ(jacobian_at(a.problem, 0.4, y), jacobian_at(b.problem, 0.4, y));
  EXPECT_EQ(taylor_part(a.problem, 0.4), taylor_part(b.problem, 0.4));
}

// The columns are compared by their names, which an unknown without size cannot have.
TEST(VectorsInFiles, AreTheirComponents) {
  const Scene vector = scene_of_text(vector_file(
      "size = \"2 + 1\"\nterms = [[1, 1.5], [\"k*i\", 0.5]]\n"
      "rhs = \"sin(u[i-1]) - size*u[i]^2 + D(u[min(i+1, size)], 0.5) + v[i]*t\"\noutside = \"t + i\"\n"
      "initial = [\"i/size\", 2]\n",
      "[unknown.v]\nsize = 3\norder = 0.7\nrhs = \"u[size + 1 - i]\"\ninitial = [0]\n"
      "[columns]\nx = \"u[1]\"\ny = \"u[2]\"\nz = \"D(u[3], 1)\"\n"));
  const Scene written = scene_of_text(
      "end = 1\n[parameters]\nk = 0.7\n"
      "[unknown.u1]\nterms = [[1, 1.5], [\"k*1\", 0.5]]\nrhs = \"sin(t) - 3*u1^2 + D(u2, 0.5) + v1*t\"\n"
      "initial = [\"1/3\", 2]\n"
      "[unknown.u2]\nterms = [[1, 1.5], [\"k*2\", 0.5]]\nrhs = \"sin(u1) - 3*u2^2 + D(u3, 0.5) + v2*t\"\n"
      "initial = [\"2/3\", 2]\n"
      "[unknown.u3]\nterms = [[1, 1.5], [\"k*3\", 0.5]]\nrhs = \"sin(u2) - 3*u3^2 + D(u3, 0.5) + v3*t\"\n"
      "initial = [\"3/3\", 2]\n"
      "[unknown.v1]\norder = 0.7\nrhs = \"u3\"\ninitial = [0]\n"
      "[unknown.v2]\norder = 0.7\nrhs = \"u2\"\ninitial = [0]\n"
      "[unknown.v3]\norder = 0.7\nrhs = \"u1\"\ninitial = [0]\n"
      "[columns]\nx = \"u1\"\ny = \"u2\"\nz = \"D(u3, 1)\"\n");
  expect_same(vector, written);
}

TEST(VectorsInFiles, HaveColumnsWithTheirIndices) {
  const Scene scene = scene_of_text(
      vector_file("size = 2\nterms = [[1, 1.5], [1, 0.5]]\nrhs = \"-u[i]\"\ninitial = [1, 0]\n"));
  EXPECT_THAT(scene.outputs.names,
              ElementsAre("u[1]", "u[2]", "D(u[1],0.5)", "D(u[1],1)", "D(u[2],0.5)", "D(u[2],1)"));
}

TEST(VectorsInFiles, HaveIntegralsDelaysAndResetsOfTheirComponents) {
  const Scene integrals =
      scene_of_text(vector_file("size = 2\norder = 0.5\nrhs = \"J(i*u[i], 0.5)\"\ninitial = [1]\n"));
  const Vec y = (Vec(4) << 0.2, 0.3, 0.5, 0.7).finished();  // u[1], u[2] and their integrals
  EXPECT_EQ(rhs_at(integrals.problem, 0.0, y), (Vec(4) << 0.5, 0.7, 0.2, 0.6).finished());
  // u[1] = 1 + t/2 before 1/2, when u[2](t) still is its value before 0, and u[3] is t.
  const Scene delayed =
      scene_of_text(vector_file("size = 2\norder = 1\nrhs = \"u[i+1](t - 0.5)/i\"\nbefore = \"0.5\"\noutside "
                                "= \"t\"\ninitial = [1]\n"));
  const auto path = find_scheme("spectral_collocation")
                        ->solve(delayed.problem, Tolerance{1e-12, 1e-12}, {.output_times = {0.5}});
  EXPECT_NEAR(path.y(0, 0), 1.25, 1e-11);
  EXPECT_NEAR(path.y(1, 0), 1.0 + (0.125 - 0.25) / 2.0, 1e-11);
  const Scene reset =
      scene_of_text(vector_file("size = 2\norder = 1\nrhs = \"1\"\ninitial = [\"i\"]\n",
                                "[event.e]\nzero = \"u[1] - 1.5\"\nset = { \"u[2]\" = \"u[1]\" }\n"));
  Vec state = (Vec(2) << 4.0, 5.0).finished();
  reset.problem.resets.front().state(0.0, (Vec(2) << 4.0, 5.0).finished(), state);
  EXPECT_EQ(state, (Vec(2) << 4.0, 4.0).finished());
}

const std::string field_file =
    "end = 1\n[parameters]\nn = 200\n[unknown.u]\nsize = \"n\"\norder = 0.5\n"
    "rhs = \"(size + 1)^2*(u[i-1] - 2*u[i] + u[i+1])\"\noutside = \"0\"\n"
    "initial = [\"sum(k, 1, 3, sin(k*pi*i/(size + 1))/k)\"]\n";

// The built-in scene is written in C++, with its own matrix.
TEST(FieldsInFiles, AreThatOfTheScene) {
  const Problem field = scene_of_text(field_file).problem,
                scene = make_scene(built_in_scenes().named("fractional_diffusion")).problem;
  ASSERT_TRUE(std::holds_alternative<SparseLinearPart>(field.derivatives));
  EXPECT_TRUE(is_linear(field));
  const Vec y = some_state(200);
  const auto& matrix = std::get<SparseLinearPart>(field.derivatives).matrix;
  EXPECT_EQ(matrix.nonZeros(), 3 * 200 - 2);
  const double size = 4.0 * 201.0 * 201.0;
  EXPECT_LT((Matrix(matrix) - Matrix(std::get<SparseLinearPart>(scene.derivatives).matrix))
                .lpNorm<Eigen::Infinity>(),
            1e-12 * size);
  EXPECT_LT((rhs_at(field, 0.1, y) - rhs_at(scene, 0.1, y)).lpNorm<Eigen::Infinity>(), 1e-12 * size);
  EXPECT_LT((taylor_part(field, 0.0) - taylor_part(scene, 0.0)).lpNorm<Eigen::Infinity>(), 1e-14);
}

// u[i] = sum over k of sin(k pi x) / k E_0.5(-4 (n+1)^2 sin(k pi / (2 (n+1)))^2 t^0.5).
TEST(FieldsInFiles, MayHaveAnExactSolution) {
  const Scene scene = scene_of_text(
      field_file +
          "[exact]\nu = \"sum(k, 1, 3, sin(k*pi*i/(size + 1))/k*mittag_leffler(0.5, 1, -4*(size + 1)^2*"
          "sin(k*pi/(2*(size + 1)))^2*sqrt(t)))\"\n",
      {{"n", 120.0}});
  const Scene known = make_scene(built_in_scenes().named("fractional_diffusion"), {{"components", 120.0}});
  const Grid grid{.end = 1.0, .steps = 64};
  const auto path = find_scheme("l1")->solve(scene.problem, grid, {});
  const auto other = find_scheme("l1")->solve(known.problem, grid, {});
  EXPECT_LT((path.y.rightCols<1>() - other.y.rightCols<1>()).lpNorm<Eigen::Infinity>(), 1e-12);
  const Vec at_end = scene.reference.at(1.0).value;
  EXPECT_LT((path.y.rightCols<1>() - at_end).lpNorm<Eigen::Infinity>(), 1e-2 * at_end.maxCoeff());
}

// D^0.8 u_i = u_(i-1) - 2 u_i + u_(i+1) + sin(u_i): the derivative is sparse and varies.
TEST(FieldsInFiles, HaveSparseJacobians) {
  const Problem field =
      scene_of_text(vector_file("size = 150\norder = 0.8\nrhs = \"u[i-1] - 2*u[i] + u[i+1] + sin(u[i])\"\n"
                                "outside = \"0\"\ninitial = [\"i/size\"]\n"))
          .problem;
  ASSERT_TRUE(std::holds_alternative<SparseJacobian>(field.derivatives));
  const Vec y = some_state(150);
  Matrix expected = Matrix::Zero(150, 150);
  expected.diagonal() = -2.0 + y.array().cos();
  expected.diagonal(1).setOnes();
  expected.diagonal(-1).setOnes();
  EXPECT_LT((jacobian_at(field, 0.0, y) - expected).lpNorm<Eigen::Infinity>(), 1e-15);
}

TEST(SumsInFormulas, AddTheirTerms) {
  ExpressionPool pool(NumberStorage::values);
  const auto value = [&](const std::string& text) {
    return pool.value(read_formula(text, names_of_t_x_y(pool), pool));
  };
  EXPECT_EQ(value("sum(j, 1, 4, j^2)"), 30.0L);
  EXPECT_EQ(value("sum(j, 1, 3, sum(k, j, 3, j*k))"), 25.0L);  // 1 (1+2+3) + 2 (2+3) + 3 3
  EXPECT_EQ(value("sum(j, 2, 1, j) + 5"), 5.0L);
  EXPECT_EQ(value("2*sum(j, -1, 1, j + 1)^2"), 18.0L);
}

TEST(VectorsInFiles, SayWhichIndexIsWrong) {
  const auto message = [](const std::string& rhs, const std::string& rest = "") {
    return message_of<std::invalid_argument>([&] {
      scene_of_text(vector_file("size = 3\norder = 1\nrhs = \"" + rhs + "\"\ninitial = [1]\n", rest));
    });
  };
  EXPECT_EQ(
      message("-u[i+1]"),
      "test.toml: line 7, column 9: for i = 3: u[4]: must have an index from 1 to 3; for another one u must "
      "have the key outside, as outside = \"0\"");
  EXPECT_EQ(message("-u"), "test.toml: line 7, column 8: for i = 1: u: must have an index, as u[1]");
  EXPECT_EQ(message("u[i/2]"),
            "test.toml: line 7, column 10: for i = 1: the index of u = 0.5: must be a whole number");
  EXPECT_THAT(message("u[t]"),
              HasSubstr("the index of u: must be a formula of whole numbers and parameters"));
  EXPECT_THAT(message("u[i] + q"), HasSubstr("for i = 1: q: no such name here"));
  EXPECT_THAT(message("w[1]"), HasSubstr("w: must be a vector, an unknown with size"));
  EXPECT_THAT(message("sum(k, 1, 2, u[k])"), HasSubstr("k: must be a new name, as in sum(j, 1, 3, u[j])"));
  EXPECT_THAT(message("u[i]", "[energy]\nvalue = \"u[7]\"\n"),
              HasSubstr("line 10, column 10: u[7]: must have an index"));
  const auto of_keys = [](const std::string& keys) {
    return message_of<std::invalid_argument>([&] { scene_of_text(vector_file(keys)); });
  };
  EXPECT_THAT(of_keys("size = 2.5\norder = 1\nrhs = \"1\"\ninitial = [1]\n"),
              HasSubstr("size = 2.5: must be a whole number"));
  EXPECT_THAT(of_keys("size = 10001\norder = 1\nrhs = \"1\"\ninitial = [1]\n"),
              HasSubstr("size = 10001: must be a number in [1, 10000]"));
  EXPECT_THAT(of_keys("outside = 0\norder = 1\nrhs = \"1\"\ninitial = [1]\n"),
              HasSubstr("outside: unknown u: must be given with size"));
  EXPECT_THAT(of_keys("size = 2\ntransfer = \"1/s\"\ninput = \"t\"\n"), HasSubstr("line 5"));
}

}  // namespace
}  // namespace fde::bench
