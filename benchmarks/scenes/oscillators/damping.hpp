// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/problem/chain.hpp"

namespace fde::bench {

// The parameters alpha, beta and tau, with the defaults of section 7 of Yin, Liu & Anh, followed by `others`.
std::vector<Parameter> damping_parameters(const std::vector<Parameter>& others);

// The coefficients of the damping terms.
struct DampingWeights {
  double mu, lambda, nu;
};

// The first row of the problem and the first column of the scene of an unknown.
struct UnknownOffset {
  Eigen::Index row = 0, column = 0;
};

// An unknown u with the terms u'' + mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u of Yin, Liu
// & Anh (5.1), (6.2): its chain, and its columns u, Dbeta_u, du, Dalpha_u. A term with coefficient 0 has no
// column. For alpha = 2 the first damping term is inertia: the leading term of the chain is (1 + inertia)
// u'', and the column Dalpha_u is u''.
class DampedUnknown {
 public:
  // initial: u(0), u'(0).
  DampedUnknown(const std::string& u, const Parameters& p, const DampingWeights& weights,
                const std::vector<double>& initial, const UnknownOffset& first = {});

  [[nodiscard]] const Chain& chain() const { return chain_; }
  [[nodiscard]] double inertia() const { return chain_.leading().coefficient - 1.0; }
  // The rows of u and u'.
  [[nodiscard]] Eigen::Index row() const { return chain_.first_row(); }
  [[nodiscard]] Eigen::Index row_of_velocity() const { return *chain_.row(1.0); }

  // The columns: names, orders as derivatives of u, and sources: a row of the problem, or, if `acceleration`
  // is true, the right-hand side of that row.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }
  struct ColumnSource {
    Eigen::Index row;
    bool acceleration;
  };
  [[nodiscard]] std::vector<ColumnSource> column_sources() const;
  // The orders at which a damping term is not the limit of its neighbours: beta = 0 where u(0) is not 0,
  // alpha = 1 where u'(0) is not 0.
  [[nodiscard]] const std::vector<Discontinuity>& discontinuities() const { return discontinuities_; }
  // The first row and column after those of this unknown.
  [[nodiscard]] UnknownOffset next() const;

  // From all columns of the scene: u, u', and the power of the damping, -u' times the damping terms.
  [[nodiscard]] double u(In columns) const { return columns[first_column_]; }
  [[nodiscard]] double du(In columns) const { return columns[column_of_velocity_]; }
  [[nodiscard]] double power(In columns) const;

 private:
  void add_column(const std::string& name, double order, double weight);

  Chain chain_;
  Eigen::Index first_column_, column_of_velocity_ = 0;
  std::vector<std::string> names_;
  std::vector<double> orders_, weights_;  // weights_: coefficient of each column in the damping
  std::vector<Discontinuity> discontinuities_;
};

// The columns of several unknowns whose rows follow each other in a problem.
Outputs outputs_of(const std::vector<DampedUnknown>& unknowns, const Problem& problem);

}  // namespace fde::bench
