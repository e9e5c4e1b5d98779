// SPDX-License-Identifier: MIT
// Derivatives of distributed order in equation files.

#include "fdebench/schemes/problem/distributed_order.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "benchmarks/equation_files/file_commands.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string equation(std::string_view weight, std::string_view from, std::string_view to,
                     std::string_view rhs = "-x", std::string_view initial = "1") {
  return fmt::format(
      "end = 2\n[unknown.x]\nterms = [{{ weight = \"{}\", from = {}, to = {} }}]\nrhs = \"{}\"\ninitial = "
      "[{}]\n",
      weight, from, to, rhs, initial);
}

struct Value {
  std::string_view t;
  double x;
};

// int_0^1 6 q (1 - q) D^q x dq = -x: the symbol is 6 ((s + 1) log s - 2 (s - 1))/log^3 s. Inverse Laplace
// transforms by mpmath (Talbot's method of degree 60, 40 digits).
TEST(DistributedOrder, RelaxesAsItsLaplaceTransform) {
  constexpr std::array known{Value{"0.001", 0.98789832301425791597}, Value{"0.5", 0.51339947021949639917},
                             Value{"2", 0.33578821472998500109}};
  for (const auto& [t, x] : known) {
    const auto row = exact(equation("6*q*(1 - q)", "0", "1"), t);
    EXPECT_NEAR(row[1], x, row[2]) << t;
    EXPECT_LT(row[2], 1e-13) << t;
  }
}

// The built-in scene with weight 1 on [0, 1], from mpmath likewise, at
// 1e100 by an integral over its spectrum: slower than any power of t, like 1/log t.
TEST(DistributedOrder, OfTheSceneDecaysLikeALogarithm) {
  constexpr std::array known{Value{"1e-6", 0.99998576180614849563}, Value{"1", 0.41030550159102619049},
                             Value{"1e6", 0.064475020148636963991}, Value{"1e100", 0.00431326622817292622}};
  for (const auto& [t, x] : known) {
    const auto row = values(fdebench(fmt::format("exact distributed_relaxation --at {}", t)));
    EXPECT_NEAR(row[1], x, row[2]) << t;
    EXPECT_LT(row[2], 2e-15) << t;
  }
}

// int_0^2 D^q x dq = -4 x: (s^2 - 1)/log s, with x(0) = 1 and x'(0) = 0.
TEST(DistributedOrder, MayExceedOne) {
  const auto row = exact(equation("1", "0", "2", "-4*x", "1, 0"), "0.5");
  EXPECT_NEAR(row[1], 0.3449319752765650155, row[3]);
  EXPECT_LT(row[3], 1e-12);
}

// The same with x'(0) = 1, which only derivatives of orders above 1 contain: int_1^2 s^(q-2) dq = (1 -
// 1/s)/log s.
TEST(DistributedOrder, StartsWithTheInitialValuesOfEachOrder) {
  const auto row = exact(equation("1", "0", "2", "-4*x", "1, 1"), "0.5");
  EXPECT_NEAR(row[1], 0.61410009482208150572, row[3]);  // by mpmath
}

// The bound contains the error of the quadrature also where that is large, next to the start.
TEST(DistributedOrder, BoundsTheErrorOfItsQuadrature) {
  const auto row = exact(equation("6*q*(1 - q)", "0", "1"), "1e-12");
  EXPECT_LT(row[2], 1e-10);
  EXPECT_GT(row[2], 1e-16);
}

// A nonlinear equation has a reference by two methods with quadratures of different nodes.
TEST(DistributedOrder, HasAReferenceForNonlinearEquations) {
  const auto text = equation("6*q*(1 - q)", "0", "1", "-x^3");
  const auto row = exact(text, "1");
  const auto run =
      values(command(text, {"solve", "--scheme", "spectral_collocation", "--accuracy", "1e-9", "--at", "1"}));
  EXPECT_NEAR(run[1], row[1], 1e-8);
  EXPECT_LT(row[2], 1e-10);
}

// With ordinary terms beside it, and in a sum of two integrals, each of a part of the orders.
TEST(DistributedOrder, IsATermAsOthersAre) {
  const auto written = [](std::string_view terms) {
    return fmt::format("end = 2\n[unknown.x]\nterms = [{}]\nrhs = \"1 - x\"\ninitial = [0]\n", terms);
  };
  const auto whole = exact(written("[1, 1], { weight = \"1 + q\", from = 0, to = 0.8 }"), "2");
  const auto parts = exact(written("{ weight = \"1 + q\", from = 0, to = 0.3 }, [1, 1], "
                                   "{ weight = \"1 + q\", from = 0.3, to = 0.8 }"),
                           "2");
  EXPECT_NEAR(whole[1], parts[1], 1e-13);
}

// A row of the smallest difference of two nodes, 0.016, gives rules on the chain the rate 1 + 0.016, L1 1;
// without a chain the trapezoidal rule has 2.
TEST(DistributedOrder, HasTheRatesOfItsTerms) {
  const auto text = equation("6*q*(1 - q)", "0", "1");
  for (const auto& [scheme, rate] :
       {std::pair{"l1", 1.0}, {"product_trapezoidal", 1.016}, {"multi_term_trapezoidal", 2.0}}) {
    const double coarse = error_at_end(text, "2", scheme, "1024"),
                 fine = error_at_end(text, "2", scheme, "2048");
    EXPECT_NEAR(std::log2(coarse / fine), rate, 0.05) << scheme;
  }
}

// The nodes are no columns.
TEST(DistributedOrder, HasTheUnknownAsColumn) {
  const auto answer = command(equation("1", "0", "2", "-4*x", "1, 0"),
                              {"solve", "--scheme", "bdf2", "--steps", "8", "--at", "2"});
  EXPECT_THAT(answer.out, StartsWith("t,x,\"D(x,1)\"\n"));
}

// sum_k c_k s^(q_k) with n nodes against int_0^1 s^q dq = (s - 1)/log s.
TEST(DistributedOrder, TakesAsFewNodesAsItsToleranceNeeds) {
  const DistributedOrder uniform{.weight = [](double /*q*/) { return 1.0; }, .from = 0.0, .to = 1.0};
  const auto error = [&](int nodes) {
    constexpr double s = 1e4;
    double sum = 0.0;
    for (const auto& [coefficient, order] : terms_of(uniform, nodes)) sum += coefficient * std::pow(s, order);
    return std::abs(sum / ((s - 1.0) / std::log(s)) - 1.0);
  };
  const int nodes = nodes_for(uniform, 1.0, 1e-10);
  EXPECT_LE(error(nodes), 1e-10);
  EXPECT_GT(error(nodes - 1), 1e-11);
  EXPECT_THROW(
      nodes_for({.weight = [](double q) { return std::abs(q - 0.3); }, .from = 0.0, .to = 1.0}, 1.0, 1e-10),
      std::invalid_argument);
}

// Two such unknowns coupled by functions that are not linear start with sums of any of their orders, which
// are too many for a series: such a file is read at once.
TEST(DistributedOrder, OfCoupledUnknownsIsReadAtOnce) {
  const auto run = command(
      "end = 0.6\n[unknown.x]\nterms = [{ weight = \"1\", from = 0, to = 1 }, [0.169, 0.24]]\n"
      "rhs = \"-0.284*asin(tanh(z))\"\ninitial = [1]\n[unknown.z]\n"
      "terms = [{ weight = \"1 + q\", from = 0, to = 0.5 }]\nrhs = \"sin(x) - z\"\ninitial = [0]\n",
      {"solve", "--scheme", "l1", "--steps", "64", "--at", "0.6"});
  EXPECT_EQ(run.code, 0);
}

TEST(DistributedOrder, IsRefusedAtItsPlace) {
  const auto refusal = [](const std::string& text) {
    const auto answer = command(text, {"solve", "--scheme", "l1", "--steps", "8"});
    EXPECT_EQ(answer.code, 2) << text;
    return answer.err.substr(answer.err.find("line"));
  };
  EXPECT_THAT(refusal(equation("abs(q - 0.3)", "0", "1")),
              HasSubstr("weight: 40 orders are too few for times up to 2: must be smooth"));
  EXPECT_THAT(refusal(equation("0", "0", "1")), HasSubstr("weight: is 0"));
  EXPECT_THAT(refusal(equation("log(q - 2)", "0", "1")), HasSubstr("weight: must be finite"));
  EXPECT_THAT(refusal(equation("t", "0", "1")),
              StartsWith("line 3, column 22: t: no such name here; there are q"));
  EXPECT_THAT(refusal(equation("1", "1", "0.5")), HasSubstr("to = 0.5: must be above from = 1"));
  EXPECT_THAT(refusal(equation("1", "0", "11")), HasSubstr("to = 11: must be"));
  EXPECT_THAT(refusal(equation("1", "0", "1") + "factor = \"x\"\n"), HasSubstr("factor: must not be given"));
  EXPECT_THAT(refusal(equation("1", "0", "1") + "[parameters]\nq = 1\n"), HasSubstr("parameter q"));
}

}  // namespace
}  // namespace fde::bench
