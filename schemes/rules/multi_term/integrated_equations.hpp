// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/problem/chain.hpp"
#include "fdebench/schemes/rules/multi_term/taylor_part_integrals.hpp"
#include "fdebench/schemes/rules/start_weights/start_correction.hpp"
#include "fdebench/schemes/rules/start_weights/start_weights.hpp"
#include "fdebench/schemes/rules/start_weights/starting_procedure.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// The multi-term equations of a problem in integrated form, in place of the system of a chain:
//   a D^L u + sum_k c_k D^(a_k) u = g,   g = force + (1 - factor) sum_k c_k D^(a_k) u.
// With T the Taylor part of u and d = u - T, which starts from 0, every derivative D^v u that is a row of the
// chain, v < L, satisfies (Diethelm & Ford, Appl. Math. Comput. 154 (2004), for v = 0)
//   D^v d + sum_k c_k/a I^(L-a_k) D^v d = I^(L-v) (g - sum_k c_k D^(a_k) T) / a.
// The integrals of T are known. The other integrals are convolution sums: over samples of D^v d with weights
// of the orders L - a_k, the same for all rows v, and over samples of g with weights of the orders L - v.

// The chain of each equation.
std::vector<Chain> chains_of(const Problem& problem);

// Why the integrated form is not applicable, as half a sentence: a leading order is above 2, or rows belong
// to no equation. nullopt: it is applicable.
std::optional<std::string> unsupported_equations_reason(const Problem& problem);

// The problem that each step solves, y = known + kappa f(t, y), with the rows of the given one: f is g / a in
// all rows of an equation, and row v has the order L - v. The given problem must outlive it.
Problem integrated_problem(const Problem& problem);

// The powers of t in D^v d and in g that starting weights of this family make exact; they follow from the
// orders.
StartingPowers starting_powers_of_equations(const WeightFamily& family, const Problem& problem);

// The memory terms of all equations.
class IntegratedEquations {
 public:
  // starting_powers: powers of t in the samples that starting weights make exact; empty: no starting weights.
  IntegratedEquations(const Problem& problem, const WeightFamily& family, const Grid& grid,
                      const Options& options, const std::vector<double>& starting_powers = {});

  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] ChosenHistory history() const { return history_->chosen(); }

  // The equations of the first steps, one for each starting power beyond the first. nullopt where
  // prepare_step(1) is false.
  [[nodiscard]] std::optional<StartingEquations> first_equations();

  // Appends y and f of integrated_problem() at t: 0, or the time of the last step.
  void push(double t, In y, In f);

  // Computes known() and kappa() for the step to t_n, after the first steps. Returns false where the step is
  // too large for a growing mode: 1 + sum_k c_k/a kappa_k <= 0, which does not hold for small enough steps.
  bool prepare_step(int n);

  // The rows at t_n are known + kappa f(t_n, y_n).
  [[nodiscard]] const Vec& known() const { return known_; }
  [[nodiscard]] const Vec& kappa() const { return kappa_; }

  void state(Archive& archive);

 private:
  // One equation. Its samples are those of its rows, then that of f.
  struct ChainSum {
    Chain chain;
    Vec ratios;                  // c_k / a
    Eigen::Index first;          // index of its first sample
    TaylorPartIntegrals starts;  // of T
    double denominator = 1.0;    // 1 + sum_k c_k/a kappa_k
  };
  static std::vector<ChainSum> chain_sums(const Problem& problem);
  [[nodiscard]] WeightTables tables(const WeightFamily& family) const;
  // The weights of an equation in the i-th sum at the first steps, one row a step.
  [[nodiscard]] Matrix first_weights_of(const ChainSum& part, Eigen::Index i) const;
  void update_taylor_part(double t);
  bool compute_factors(int n);

  Grid grid_;
  std::vector<ChainSum> parts_;
  WeightTables tables_;  // of each sum; the order of the i-th is L - node i
  std::unique_ptr<History> history_;
  std::vector<StartingCorrection> corrections_;  // of each sum; empty: no starting weights
  Matrix factors_;      // weights of the newest sample, a row an equation, a column a sum
  Matrix sums_;         // one column a sum
  double time_ = -1.0;  // time of taylor_derivatives_ and taylor_integrals_
  Vec sample_, taylor_derivatives_, taylor_integrals_, known_, kappa_;
};

}  // namespace fde
