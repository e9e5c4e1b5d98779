// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/constraints/fractional_line.hpp"

#include "fdebench/reference/linear/closed_forms/closed_form.hpp"
#include "fdebench/reference/linear/linear_solution.hpp"

namespace fde::bench {
namespace {

constexpr const char* name = "fractional_constraint_1d";

struct ExactLine {
  explicit ExactLine(const FractionalLine& line)
      : alpha(reference::shortest_decimal(line.alpha)),
        a(reference::shortest_decimal(line.a)),
        b(reference::shortest_decimal(line.b)),
        q0(reference::shortest_decimal(line.q0)),
        q1(reference::shortest_decimal(line.q1)),
        q2(line.alpha > 2.0 ? reference::shortest_decimal(line.q2) : reference::Rational(0)),
        constant(line.exact_constant()) {}

  reference::Rational alpha, a, b, q0, q1, q2, constant;
};

// Laplace transforms for alpha up to 1, numerators over a s + b s^alpha:
//   Q: q0 (a + b s^(alpha-1)) + C0/s,   V: C0,   W: C0 s^(alpha-1),   V': -q1 b s^alpha.
reference::LinearTransform denominator_up_to_one(const ExactLine& line) {
  reference::LinearTransform transform;
  add_term(transform.characteristic, 1, line.a);
  add_term(transform.characteristic, line.alpha, line.b);
  transform.generators = {1, line.alpha};
  return transform;
}

reference::LinearTransform columns_up_to_one(const ExactLine& line) {
  const auto& [alpha, a, b, q0, q1, q2, constant] = line;
  reference::LinearTransform transform = denominator_up_to_one(line);
  auto& numerators = transform.group_at(0, 3).numerators;
  add_term(numerators[0], 0, reference::Rational(q0 * a));
  add_term(numerators[0], reference::Rational(alpha - 1), reference::Rational(q0 * b));
  add_term(numerators[0], -1, constant);
  add_term(numerators[1], 0, constant);
  add_term(numerators[2], reference::Rational(alpha - 1), constant);
  return transform;
}

reference::LinearTransform multiplier_up_to_one(const ExactLine& line) {
  reference::LinearTransform transform = denominator_up_to_one(line);
  add_term(transform.group_at(0, 1).numerators[0], line.alpha,
           reference::Rational(-line.q1 * line.b / line.a));
  return transform;
}

// Laplace transforms for alpha above 1, nu = alpha - 1, numerators over a + b s^nu:
//   Q: q0 (a + b s^nu)/s + b q1 s^(nu-2) + C0/s^2 + b q2 s^(nu-3),
//   V: b q1 s^(nu-1) + C0/s + b q2 s^(nu-2),   W: (C0 - a q1) s^(nu-1) - a q2 s^(nu-2),
//   V': C0 - a q1 + b q2 s^(nu-1).
reference::LinearTransform denominator_above_one(const ExactLine& line) {
  const reference::Rational nu = line.alpha - 1;
  reference::LinearTransform transform;
  add_term(transform.characteristic, 0, line.a);
  add_term(transform.characteristic, nu, line.b);
  transform.generators = {1, nu};
  return transform;
}

reference::LinearTransform columns_above_one(const ExactLine& line) {
  const auto& [alpha, a, b, q0, q1, q2, constant] = line;
  const reference::Rational nu = alpha - 1;
  reference::LinearTransform transform = denominator_above_one(line);
  auto& numerators = transform.group_at(0, 3).numerators;
  add_term(numerators[0], -1, reference::Rational(q0 * a));
  add_term(numerators[0], reference::Rational(nu - 1), reference::Rational(q0 * b));
  add_term(numerators[0], reference::Rational(nu - 2), reference::Rational(b * q1));
  add_term(numerators[0], -2, constant);
  add_term(numerators[0], reference::Rational(nu - 3), reference::Rational(b * q2));
  add_term(numerators[1], reference::Rational(nu - 1), reference::Rational(b * q1));
  add_term(numerators[1], -1, constant);
  add_term(numerators[1], reference::Rational(nu - 2), reference::Rational(b * q2));
  add_term(numerators[2], reference::Rational(nu - 1), reference::Rational(constant - a * q1));
  add_term(numerators[2], reference::Rational(nu - 2), reference::Rational(-a * q2));
  return transform;
}

reference::LinearTransform multiplier_above_one(const ExactLine& line) {
  const auto& [alpha, a, b, q0, q1, q2, constant] = line;
  reference::LinearTransform transform = denominator_above_one(line);
  auto& numerator = transform.group_at(0, 1).numerators[0];
  add_term(numerator, 0, reference::Rational((constant - a * q1) / a));
  add_term(numerator, reference::Rational(alpha - 2), reference::Rational(b * q2 / a));
  return transform;
}

// q0 + q1 t; D^alpha q = 0 if it is a column.
struct UniformMotion {
  double q0, q1;
  bool has_memory;

  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& t) const {
    using std::abs;
    const Real start = reference::from_shortest_decimal<Real>(q0),
               speed = reference::from_shortest_decimal<Real>(q1);
    std::vector<reference::ConditionedValue<Real>> columns{
        {Real(start + speed * t), Real(abs(start) + abs(speed) * t)}, {speed, Real(abs(speed))}};
    if (has_memory) columns.push_back({Real(0), Real(0)});
    return columns;
  }
};

struct ZeroMultiplier {
  template <class Real>
  [[nodiscard]] std::vector<reference::ConditionedValue<Real>> operator()(const Real& /*t*/) const {
    return {{Real(0), Real(0)}};
  }
};

}  // namespace

reference::Rational FractionalLine::exact_constant() const {
  if (explicit_constant) return reference::shortest_decimal(*explicit_constant);
  const reference::Rational of_memory =
      alpha == 1.0 ? reference::shortest_decimal(b) : reference::Rational(0);
  return (reference::shortest_decimal(a) + of_memory) * reference::shortest_decimal(q1);
}

bool FractionalLine::is_consistent_at_start() const {
  FractionalLine at_start = *this;
  at_start.explicit_constant.reset();
  return exact_constant() == at_start.exact_constant();
}

bool FractionalLine::is_uniform_motion() const {
  return b == 0.0 || (alpha > 1.0 && alpha <= 2.0 && is_consistent_at_start());
}

reference::Reference exact_columns(const FractionalLine& line) {
  if (line.is_uniform_motion()) return reference::closed_form(UniformMotion{line.q0, line.q1, line.b != 0.0});
  return reference::linear_reference(name, [line] {
    return line.alpha <= 1.0 ? columns_up_to_one(ExactLine(line)) : columns_above_one(ExactLine(line));
  });
}

// At order 1 q' is constant.
reference::Reference exact_multiplier(const FractionalLine& line) {
  if (line.is_uniform_motion() || line.alpha == 1.0) return reference::closed_form(ZeroMultiplier{});
  return reference::linear_reference(name, [line] {
    return line.alpha < 1.0 ? multiplier_up_to_one(ExactLine(line)) : multiplier_above_one(ExactLine(line));
  });
}

}  // namespace fde::bench
