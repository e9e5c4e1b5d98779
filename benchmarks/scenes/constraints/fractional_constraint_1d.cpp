// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "fdebench/benchmarks/scenes/constraints/fractional_line.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {
namespace {

using Line = FractionalLine;

// The equation as a chain, with the higher of the two derivatives as the leading term.
Chain chain_of(const Line& line) {
  const double alpha = line.alpha, a = line.a, b = line.b, q0 = line.q0;
  if (b == 0.0) return {{a, 1.0}, {}, {q0}};
  if (alpha == 1.0) return {{a + b, 1.0}, {}, {q0}};
  if (alpha < 1.0) return {{a, 1.0}, {{b, alpha}}, {q0}};
  if (alpha <= 2.0) return {{b, alpha}, {{a, 1.0}}, {q0, line.q1}};
  return {{b, alpha}, {{a, 1.0}}, {q0, line.q1, line.q2}};
}

// Columns q, v and w; those that are not components of the chain follow from the constraint.
Outputs columns_of(const Line& line) {
  const auto& [alpha, a, b, q0, q1, q2, given] = line;
  const double constant = line.constant();
  if (b == 0.0) {
    return {{"q", "v"}, [v = constant / a](double, In y, Out columns) { columns << y[0], v; }};
  }
  const std::vector<std::string> names{"q", "v", "w"};
  if (alpha == 1.0) {
    return {names, [v = constant / (a + b)](double, In y, Out columns) { columns << y[0], v, v; }};
  }
  if (alpha < 1.0) {
    return {names, [=, a = a, b = b](double, In y, Out columns) {
              columns << y[0], (constant - b * y[1]) / a, y[1];
            }};
  }
  return {names,
          [=, a = a, b = b](double, In y, Out columns) { columns << y[0], y[1], (constant - a * y[1]) / b; }};
}

Problem problem_of(const Line& line) {
  const double constant = line.constant();
  return chain_problem({{.chain = chain_of(line),
                         .force = [=](double, In) { return constant; },
                         .derivatives = LinearForce{0.0}}},
                       10.0);
}

// Above order 2, q'' is a component but not a column: it is not measured.
Smoothness smoothness_of(const Problem& problem) {
  Vec load(problem.size());
  problem.rhs(0.0, Vec::Zero(problem.size()), load);
  const Matrix& linear = std::get<DenseLinearPart>(problem.derivatives).matrix;
  Smoothness smoothness = linear_smoothness(problem.components, linear, {{0.0, load}});
  for (Eigen::Index i = 2; i < problem.size(); ++i) smoothness.unmeasured.push_back(i);
  return smoothness;
}

Constraint constraint_of(const Line& line) {
  return {1, [a = line.a, b = line.b, constant = line.constant()](double, In columns, Out f) {
            f[0] = a * columns[1] - constant;
            if (b != 0.0) f[0] += b * columns[2];
          }};
}

// v starts with the powers of component 1: v itself, or w, from which v follows.
std::vector<MemoryColumn> memories_of(const Line& line, const Smoothness& smoothness) {
  if (line.b == 0.0 || line.alpha == 1.0 || line.alpha >= 2.0) return {};
  return {{2, 1, line.alpha, smoothness.powers[1]}};
}

// The multiplier is lambda = q''/a.
Reactions reactions_of(const Line& line, const Smoothness& smoothness) {
  const double a = line.a;
  if (a == 0.0) return {};
  Reactions reactions{.names = {"lambda"},
                      .power = [a](double, In columns, In lambda) { return a * lambda[0] * columns[1]; },
                      .exact = exact_multiplier(line)};
  if (line.is_uniform_motion() || line.alpha == 1.0) {
    reactions.multipliers = [](double, In, In, Out lambda) { lambda[0] = 0.0; };
    return reactions;
  }
  reactions.differentiated_columns = {1};
  reactions.start_exponents = smoothness.powers[1];
  reactions.multipliers = [a](double, In, In rates, Out lambda) { lambda[0] = rates[0] / a; };
  if (line.alpha < 1.0 && line.q1 == 0.0) reactions.initial_multipliers = Vec::Zero(1);
  if (line.alpha == 2.0)
    reactions.initial_multipliers = Vec::Constant(1, (line.constant() - a * line.q1) / (line.b * a));
  if (line.alpha > 2.0) reactions.initial_multipliers = Vec::Constant(1, line.q2 / a);
  return reactions;
}

void require_well_posed(const Line& line) {
  const auto& [alpha, a, b, q0, q1, q2, given] = line;
  if (alpha == 1.0 && a + b == 0.0) reject("b", b, "other than -a for alpha = 1");
  if (alpha <= 1.0 && a == 0.0) reject("a", 0.0, "other than 0 for alpha up to 1");
  if (alpha > 2.0 && b == 0.0) reject("b", 0.0, "other than 0 for alpha above 2");
  if (a == 0.0 && b == 0.0) reject("a", 0.0, "other than 0 for b = 0");
  if (line.is_consistent_at_start()) return;
  if (alpha == 1.0)
    reject("C0", *given, fmt::format("(a+b)*q1 = {} for alpha = 1", line.constant_at_start()));
  if (alpha < 1.0) reject("C0", *given, fmt::format("a*q1 = {} for alpha below 1", a * q1));
  if (b == 0.0) reject("C0", *given, fmt::format("a*q1 = {} for b = 0", a * q1));
}

}  // namespace

// a q' + b D^alpha q = C0. The solutions of (50)-(54) in their corrected form, with w = b/a, nu = alpha - 1:
//   alpha < 1        q0 + q1 t E_{1-alpha,2}(-w t^(1-alpha)),  C0 = a q1,
//   1 < alpha <= 2   q0 + q1 t + (C0 - a q1)/b t^alpha E_{nu,alpha+1}(-t^nu/w),
//   alpha > 2        the same + q2 t^2 E_{nu,3}(-t^nu/w).
// At alpha = 1 it is (a + b) q' = C0 = (a + b) q1. As alpha -> 1 from below, q' changes from q1 to a q1 / (a
// + b) within a time that tends to 0. For w < 0 solutions grow.
SceneFactory fractional_constraint_1d() {
  return {.id = "fractional_constraint_1d",
          .title = "Point on a line with a fractional constraint",
          .source = "Tarasov & Zaslavsky 2006, eqs 44-48 (47, 48 corrected)",
          .parameters = {{"alpha",
                          0.5,
                          {.low = 0.0, .high = 3.0, .open_low = true, .open_high = true},
                          "order of the constraint"},
                         {"a", 1.0, any_number, "weight of q'"},
                         {"b", 0.5, any_number, "weight of D^alpha q"},
                         {"q0", 1.0, any_number, "q(0)"},
                         {"q1", 0.5, any_number, "q'(0)"},
                         {"q2", 0.3, any_number, "q''(0), which alpha above 2 needs"},
                         derived_number("C0", "a*q1", any_number,
                                        "what a q' + b D^alpha q is; (a+b)*q1 at alpha = 1, free above")},
          .make = [](const Parameters& p) -> Scene {
            const Line line{p["alpha"], p["a"], p["b"], p["q0"], p["q1"], p["q2"], p.explicit_value("C0")};
            require_well_posed(line);
            const Problem problem = problem_of(line);
            const Smoothness smoothness = smoothness_of(problem);
            return {.problem = problem,
                    .smoothness = smoothness,
                    .outputs = columns_of(line),
                    .reference = exact_columns(line),
                    .constraint = constraint_of(line),
                    .memory_columns = memories_of(line, smoothness),
                    .reactions = reactions_of(line, smoothness)};
          },
          .equations = {
              {.unknown = "q", .terms = {{"a", "1"}, {"b", "alpha"}}, .rhs = "C0", .initial = {"q0", "q1"}}}};
}

}  // namespace fde::bench
