#pragma once

#include <string>
#include <vector>

#include "problem/chain.hpp"
#include "scenes/scene.hpp"

namespace fde {

// The orders alpha, beta and the time tau, with the defaults of section 7, before these others.
std::vector<Parameter> damping_parameters(const std::vector<Parameter>& others);

// The weights of the terms of damping.
struct DampingWeights {
  double mu, lambda, nu;
};

// The first row of the problem and the first column of the scene that belong to an unknown.
struct FirstOf {
  Eigen::Index row = 0, column = 0;
};

// An unknown u that has the damping mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u of Yin, Liu
// & Anh (5.1), (6.2) beside u'': its chain, and its columns u, Dbeta_u, du, Dalpha_u. A term of weight 0 has
// no column. Of order alpha = 2 the first term is inertia: the chain's leading term is (1 + inertia) u'', and
// the column Dalpha_u is u''.
class DampedUnknown {
 public:
  // initial: u(0), u'(0).
  DampedUnknown(const std::string& u, const Parameters& p, const DampingWeights& weights,
                const std::vector<double>& initial, const FirstOf& first = {});

  [[nodiscard]] const Chain& chain() const { return chain_; }
  [[nodiscard]] double inertia() const { return chain_.leading().coefficient - 1.0; }
  // The rows that are u and u'.
  [[nodiscard]] Eigen::Index row() const { return chain_.first(); }
  [[nodiscard]] Eigen::Index row_of_velocity() const { return *chain_.row(1.0); }

  // The columns: names, orders as derivatives of u, and what they show: rows of the problem, or where
  // `acceleration` is true the right-hand side of the row.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }
  struct Shown {
    Eigen::Index row;
    bool acceleration;
  };
  [[nodiscard]] std::vector<Shown> shown() const;
  // The orders at which a term of damping is not what it tends to: beta = 0 where u(0) is not 0, alpha = 1
  // where u'(0) is not.
  [[nodiscard]] const std::vector<Discontinuity>& discontinuities() const { return discontinuities_; }
  // Where an unknown behind this one begins.
  [[nodiscard]] FirstOf next() const;

  // Of all columns of the scene: u, u', and -u' times the damping, which is the power that it takes.
  [[nodiscard]] double u(In columns) const { return columns[first_column_]; }
  [[nodiscard]] double du(In columns) const { return columns[column_of_velocity_]; }
  [[nodiscard]] double power(In columns) const;

 private:
  void add_column(const std::string& name, double order, double weight);

  Chain chain_;
  Eigen::Index first_column_, column_of_velocity_ = 0;
  std::vector<std::string> names_;
  std::vector<double> orders_, weights_;  // of the columns in the damping
  std::vector<Discontinuity> discontinuities_;
};

// The columns of unknowns that stand one behind the other in a problem.
Outputs outputs_of(const std::vector<DampedUnknown>& unknowns, const Problem& problem);

}  // namespace fde
