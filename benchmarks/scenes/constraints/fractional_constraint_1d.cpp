#include "closed_forms/power_sum.hpp"
#include "linear/linear_equation.hpp"
#include "linear/linear_solution.hpp"
#include "problem/chain_problem.hpp"
#include "problem/linear_smoothness.hpp"
#include "scenes/scene.hpp"

namespace fde {
namespace {

// a q' + b D^alpha q = a q1 with its initial values as decimals, so that no product of them is rounded.
struct Line {
  double alpha, a, b, q0, q1, q2;
};

// alpha <= 1: Q = (q0 (a + b s^(alpha-1)) + a q1/s) / (a s + b s^alpha).
LinearTransform transform_up_to_one(const Line& line) {
  const Rational alpha = exact_decimal(line.alpha), a = exact_decimal(line.a), b = exact_decimal(line.b),
                 q0 = exact_decimal(line.q0), q1 = exact_decimal(line.q1);
  LinearTransform transform;
  add_term(transform.characteristic, 1, a);
  add_term(transform.characteristic, alpha, b);
  auto& numerator = transform.group_from(0, 1).numerators.front();
  add_term(numerator, 0, Rational(q0 * a));
  add_term(numerator, Rational(alpha - 1), Rational(q0 * b));
  add_term(numerator, -1, Rational(a * q1));
  transform.generators = {1, alpha};
  return transform;
}

// 2 < alpha < 3: Q = q0/s + q1/s^2 + b q2 s^(alpha-4) / (a + b s^(alpha-1)).
LinearTransform transform_above_two(const Line& line) {
  const Rational nu = exact_decimal(line.alpha) - 1, a = exact_decimal(line.a), b = exact_decimal(line.b);
  LinearTransform transform;
  add_term(transform.characteristic, 0, a);
  add_term(transform.characteristic, nu, b);
  auto& numerator = transform.group_from(0, 1).numerators.front();
  for (const auto& [value, power] : {std::pair{line.q0, -1}, {line.q1, -2}}) {
    add_term(numerator, power, Rational(a * exact_decimal(value)));
    add_term(numerator, Rational(nu + power), Rational(b * exact_decimal(value)));
  }
  add_term(numerator, Rational(nu - 3), Rational(b * exact_decimal(line.q2)));
  transform.generators = {1, nu};
  return transform;
}

Reference exact_of(const Line& line) {
  constexpr const char* name = "fractional_constraint_1d";
  if (line.alpha <= 1.0) return linear_reference(name, [line] { return transform_up_to_one(line); });
  if (line.alpha <= 2.0 || line.a == 0.0)
    return power_sum({{line.q0, 0.0}, {line.q1, 1.0}, {line.alpha > 2.0 ? line.q2 / 2.0 : 0.0, 2.0}});
  return linear_reference(name, [line] { return transform_above_two(line); });
}

// The equation as a chain: the higher of the two derivatives leads.
Chain chain_of(const Line& line) {
  const auto& [alpha, a, b, q0, q1, q2] = line;
  if (b == 0.0) return {{a, 1.0}, {}, {q0}};
  if (alpha == 1.0) return {{a + b, 1.0}, {}, {q0}};
  if (alpha < 1.0) return {{a, 1.0}, {{b, alpha}}, {q0}};
  if (alpha <= 2.0) return {{b, alpha}, {{a, 1.0}}, {q0, q1}};
  return {{b, alpha}, {{a, 1.0}}, {q0, q1, q2}};
}

Problem problem_of(const Line& line) {
  const double constant = line.a * line.q1;
  return chain_problem({{.chain = chain_of(line),
                         .force = [=](double, In) { return constant; },
                         .derivatives = LinearForce{0.0}}},
                       10.0);
}

Smoothness starts_of(const Problem& problem) {
  Vec load(problem.size());
  problem.rhs(0.0, Vec::Zero(problem.size()), load);
  const Matrix& linear = std::get<DenseLinearPart>(problem.derivatives).matrix;
  Smoothness smoothness = linear_smoothness(problem.components, linear, {{0.0, load}});
  for (Eigen::Index i = 1; i < problem.size(); ++i) smoothness.hidden.push_back(i);
  return smoothness;
}

void require_posed(const Line& line) {
  if (line.alpha == 1.0 && line.a + line.b == 0.0) reject("b", line.b, "other than -a for alpha = 1");
  if (line.alpha <= 1.0 && line.a == 0.0) reject("a", 0.0, "other than 0 for alpha up to 1");
  if (line.alpha > 2.0 && line.b == 0.0) reject("b", 0.0, "other than 0 for alpha above 2");
  if (line.a == 0.0 && line.b == 0.0) reject("a", 0.0, "other than 0 for b = 0");
}

}  // namespace

// a q' + b D^alpha q = C0, C0 = a q1. The solutions of (50)-(54) in their corrected form, with w = b/a:
//   alpha < 1        q0 + q1 t E_{1-alpha,2}(-w t^(1-alpha)),
//   1 < alpha <= 2   q0 + q1 t,
//   alpha > 2        q0 + q1 t + q2 t^2 E_{alpha-1,3}(-t^(alpha-1)/w).
// alpha = 1 is the limit from below, (a + b) q' = a q1. For w < 0 solutions grow.
SceneMaker fractional_constraint_1d() {
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
                         {"q1", 0.5, any_number, "q'(0); a q' + b D^alpha q stays a q1"},
                         {"q2", 0.3, any_number, "q''(0), which alpha above 2 needs"}},
          .make = [](const Parameters& p) -> Scene {
            const Line line{p["alpha"], p["a"], p["b"], p["q0"], p["q1"], p["q2"]};
            require_posed(line);
            const Problem problem = problem_of(line);
            return {.problem = problem,
                    .smoothness = starts_of(problem),
                    .outputs = picked({"q"}, {0}),
                    .reference = exact_of(line)};
          }};
}

}  // namespace fde
