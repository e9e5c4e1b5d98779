// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/mechanics/algebra.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench::mechanics {

// w = D^order q of one coordinate, the Caputo derivative from t = 0, in forces or constraints. Orders in (0,
// 2). Order 1 is the limit of constraints of order below 1: w = v, but the reaction is not along df/dw.
struct MemoryTerm {
  std::size_t coordinate;
  double order;
};

// A mechanical system with n coordinates: d/dt dL/dv - dL/dq = F + (df/dv)^T lambda, f(t, q, v, w) = 0, with
// Chetaev's rule for the reaction (Tarasov & Zaslavsky 2006, 9, 29, 32). L, F and f are expressions of t, the
// coordinates q, the velocities v and the memory terms w. These are the columns of the scene: column c is
// variable c + 1 of an expression.
struct MechanicalSystem {
  std::vector<std::string> coordinates{};
  Vec position{}, velocity{};  // at t = 0
  std::vector<MemoryTerm> memory{};
  Expression lagrangian{};
  Expressions forces{};       // one for each coordinate, covariant
  Expressions constraints{};  // may be empty
  std::size_t unshown = 0;    // memory terms of order 1, the last ones, that are not columns

  [[nodiscard]] std::size_t size() const { return coordinates.size(); }
  // The variables of the coordinates, of the velocities and of the memory terms.
  [[nodiscard]] std::vector<int> q() const { return variables(0, size()); }
  [[nodiscard]] std::vector<int> v() const { return variables(size(), size()); }
  [[nodiscard]] std::vector<int> w() const { return variables(2 * size(), memory.size()); }
  // The number of variables of the columns and of memory terms that are not shown.
  [[nodiscard]] std::size_t column_count() const { return 2 * size() + memory.size(); }
  // The number of columns; no expression in which at_order_one() has replaced terms contains others.
  [[nodiscard]] std::size_t shown_count() const { return column_count() - unshown; }
  // Further variables, after those of the columns: the rates w' of the memory terms.
  [[nodiscard]] std::vector<int> rates() const { return variables(column_count(), memory.size()); }

 private:
  static std::vector<int> variables(std::size_t first, std::size_t count) {
    std::vector<int> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(static_cast<int>(first + i) + 1);
    return all;
  }
};

// The columns at t = 0: q(0), v(0), and w(0), which is v(0) at order 1 and otherwise 0.
Vec columns_at_start(const MechanicalSystem& system);

// The value of expressions of t and the columns at t = 0.
Vec values_at(const ExpressionPool& pool, const Expressions& of, double t, In columns);

// sum, or 0 if |sum| is within rounding of `size`, the sum of the absolute values of its terms.
double zero_if_rounding(double sum, double size);

// Four formulations of the same equations. They differ in the treatment of the constraint: see
// docs/mechanics.md.
enum class Formulation {
  integrated,    // velocities from projected ones and the constraint: no singular term, no own drift
  acceleration,  // the constraint differentiated and solved for the multiplier (Tarasov & Zaslavsky 37)
  stabilised,    // the same with df/dt + kappa f = 0 (Baumgarte 1972)
  multiplier,    // the constraint as an algebraic row, the multiplier as an unknown
};

std::string name_of(Formulation formulation);

// Throws std::invalid_argument if no formulation has this name.
Formulation formulation_named(std::string_view name);

// All formulations, for constraints that are affine in the velocity. The first is the default.
const std::vector<Formulation>& all_formulations();
// The formulations for any constraint: all except integrated.
const std::vector<Formulation>& unprojected_formulations();

// The parameter `formulation`, a choice from `fitting` (the first is the default), and, if stabilised is
// among them, `kappa`.
std::vector<Parameter> choice_of_formulation(const std::vector<Formulation>& fitting);

// The formulation that such parameters select.
struct FormulationChoice {
  Formulation formulation = Formulation::integrated;
  double kappa = 0.0;  // nonzero for stabilised only
};
FormulationChoice formulation_choice_of(const Parameters& parameters);

}  // namespace fde::bench::mechanics
