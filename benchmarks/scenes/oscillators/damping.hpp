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
// no column.
class DampedUnknown {
 public:
  // initial: u(0), u'(0).
  DampedUnknown(const std::string& u, const Parameters& p, const DampingWeights& weights,
                std::vector<double> initial, const FirstOf& first = {});

  [[nodiscard]] const Chain& chain() const { return chain_; }
  // The rows that are u and u'.
  [[nodiscard]] Eigen::Index row() const { return chain_.first(); }
  [[nodiscard]] Eigen::Index row_of_velocity() const { return *chain_.row(1.0); }

  // The columns: names, orders as derivatives of u, and the rows that they show.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const std::vector<double>& orders() const { return orders_; }
  [[nodiscard]] std::vector<Eigen::Index> rows() const;
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
};

// The columns of unknowns that stand one behind the other.
Outputs outputs_of(const std::vector<DampedUnknown>& unknowns);

}  // namespace fde
