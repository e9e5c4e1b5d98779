// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde {

// The left side of a multi-term equation as rows of a multi-order system,
//   a D^leading u + factor * sum_k c_k D^(a_k) u = force        (Yin, Liu & Anh 2007, eqs 1.1, 2.1, 3.9).
// The nodes are 0, the orders a_k and the integers below leading, increasing. Row first_row + i is D^(node i)
// u, of order node i+1 - node i. Terms with coefficient 0 are dropped; integer nodes remain, because they
// carry the initial values.
class Chain {
 public:
  // initial[k] = u^(k)(0) for k < ceil(leading); the last ones may be missing (Problem::conditions). Throws
  // std::invalid_argument when a term's order is outside [0, leading) or the coefficient of D^leading u is 0.
  Chain(Term leading, const std::vector<Term>& terms, std::vector<double> initial,
        Eigen::Index first_row = 0);
  // D^leading u = force as a single row, also for a leading order above 1.
  static Chain single_row(Term leading, std::vector<double> initial, Eigen::Index first_row = 0);

  [[nodiscard]] Term leading() const { return leading_; }
  [[nodiscard]] const std::vector<double>& initial() const { return initial_; }
  // By increasing order, each order once; no coefficient is 0.
  [[nodiscard]] std::vector<Term> terms() const;

  // Row first_row + i is D^(nodes()[i]) u; coefficients()[i] is the c_k of that order, or 0. size() entries
  // each.
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
  [[nodiscard]] const Vec& coefficients() const { return coefficients_; }

  [[nodiscard]] Eigen::Index first_row() const { return first_row_; }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(nodes_.size()); }
  // The index of the row D^order u; nullopt where order is not a node (compared exactly).
  [[nodiscard]] std::optional<Eigen::Index> row(double order) const;
  // The rows as components, with the initial values at the integer nodes and 0 elsewhere (eq. 2.2). A single
  // row has all of them.
  [[nodiscard]] std::vector<Component> components() const;

  // The chain with 1 for each missing initial value.
  [[nodiscard]] Chain with_some_initial_values() const;

 private:
  Term leading_;
  std::vector<double> nodes_, initial_;
  Vec coefficients_;
  Eigen::Index first_row_;
};

// The powers of t at t = 0 of all components of these chains, in the order of the chains, when the forces are
// smooth functions of all u. Precondition: all chains have the same leading order, and there is at least one.
Smoothness smoothness_of_chains(const std::vector<Chain>& chains);

// How the gradient by y of force(t, y) - factor(t, y) * sum is given, with sum = sum_k c_k D^(a_k) u held
// constant.
struct LinearForce {
  double by_u;  // the force is by_u * u + (a function of t), the factor 1
};
struct ForceGradient {
  // Adds this gradient to `gradient`, which has one entry per row of the problem.
  std::function<void(double t, In y, double sum, Out gradient)> add;
};

// A multi-term equation of a scene: its left side, its force and their derivatives. y is the state of the
// whole problem, so equations may be coupled.
struct MultiTermEquation {
  Chain chain;
  std::function<double(double t, In y)> force;
  std::function<double(double t, In y)> factor{};  // empty: 1
  std::variant<NoDerivatives, LinearForce, ForceGradient> derivatives{};
};

// The problem of these equations on 0 < t <= end: components, right-hand side, derivatives as far as all
// equations give them, and Problem::equations. Throws std::invalid_argument where the rows of the chains are
// not contiguous from row 0 on.
Problem chain_problem(const std::vector<MultiTermEquation>& equations, double end);

// The chain of one of problem.equations: its nodes, coefficients and initial values.
Chain chain_of(const Problem& problem, const Equation& equation);

}  // namespace fde
