// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "fdebench/reference/two_sided/nodal_basis.hpp"

namespace fde::reference {

// Values of y at all nodes, one row per node, and the unknown initial values of a problem.
struct NodalValues {
  Matrix y;
  Vec unknown;

  // The largest modulus of all entries.
  [[nodiscard]] double size() const;
};

// The residuals of the equations at the nodes, one row per node, and of the conditions.
struct NodalResidual {
  Matrix rows;
  Vec conditions;

  [[nodiscard]] double norm() const;  // sqrt(|rows|^2 / nodes + |conditions|^2)
};

// The Volterra form of a problem at all nodes of a basis at once,
//   y_i = start_i + 1/Gamma(g_i) int (t-s)^(g_i-1) f_i ds,
// with the integral from the end for right derivatives; start_i is the Taylor part with the unknown initial
// values. The problem and the basis must outlive this object.
class NodalEquations {
 public:
  // Throws std::invalid_argument for algebraic rows.
  NodalEquations(const Problem& problem, const NodalBasis& basis);

  // The Taylor parts, 0 for unknown initial values.
  [[nodiscard]] NodalValues start() const;
  [[nodiscard]] Matrix rhs(const Matrix& y) const;
  [[nodiscard]] NodalResidual residual(const NodalValues& values) const;
  // The Newton increment.
  [[nodiscard]] NodalValues increment(const NodalValues& values, const NodalResidual& residual) const;

  // y at any time, from f at the nodes.
  [[nodiscard]] Vec at(RelativeTime t, const Matrix& f, In unknown) const;

 private:
  using KernelKey = std::pair<double, Side>;  // rows of the same order and side share their weights

  [[nodiscard]] Eigen::Index nodes() const { return std::ssize(basis_.nodes); }
  [[nodiscard]] RelativeTime node(Eigen::Index m) const { return basis_.nodes[static_cast<std::size_t>(m)]; }
  [[nodiscard]] double time_from_side(Eigen::Index i, RelativeTime t) const;
  [[nodiscard]] double time(RelativeTime t) const;
  [[nodiscard]] Vec taylor_part_at(RelativeTime t, In unknown) const;
  [[nodiscard]] Matrix taylor_part_at_nodes(In unknown) const;
  [[nodiscard]] Vec conditions(const Matrix& y) const;
  [[nodiscard]] Vec conditions_along(const Matrix& y, const Matrix& change) const;

  // An unknown initial value: the coefficient of (time from the side of the component)^power / power!.
  struct Unknown {
    Eigen::Index component;
    int power;
  };

  const Problem& problem_;
  const NodalBasis& basis_;
  std::vector<Unknown> unknown_;
  std::map<KernelKey, NodalBasis::Row> rows_;  // the weights of f in y at any time
  std::vector<Matrix> weights_;                // at the nodes, for each component
};

// Solution of a problem with left and right derivatives, unknown initial values and conditions, at all nodes
// of a basis at once by Newton's method. The problem and the basis must outlive this object.
class NodalSolution {
 public:
  // Newton's method starts from y = start(t) at the nodes, or from the Taylor part. Throws std::runtime_error
  // where it does not converge, std::invalid_argument for algebraic rows.
  NodalSolution(const Problem& problem, const NodalBasis& basis,
                const std::function<Vec(RelativeTime t)>& start = {});

  // y at the nodes, one row per node.
  [[nodiscard]] const Matrix& at_nodes() const { return values_.y; }
  // y at any time, by the integral of f.
  [[nodiscard]] Vec at(RelativeTime t) const { return equations_.at(t, f_, values_.unknown); }

 private:
  NodalEquations equations_;
  NodalValues values_;
  Matrix f_;
};

// The smallest, by the mean of |y|^2 over time, of the solutions that Newton's method finds from
// initial_guesses(). Throws std::runtime_error where it finds none. The problem and the basis must outlive
// the result.
NodalSolution smallest_solution(const Problem& problem, const NodalBasis& basis);

}  // namespace fde::reference
