#pragma once

#include <string>
#include <vector>

#include "problem/chain.hpp"
#include "scenes/scene.hpp"

namespace fde {

// The damping mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u of Yin, Liu & Anh (5.1), (6.2),
// as terms.
std::vector<Term> damping_terms(const Parameters& p, double mu, double lambda, double nu);

// The orders alpha, beta and the time tau, with the defaults of section 7.
std::vector<Parameter> damping_parameters();

// The columns u, Dbeta_u, du, Dalpha_u of a damped equation; what its chain drops is left out. from: where
// they begin among the columns of the scene.
struct DampedColumns {
  DampedColumns(const std::vector<Term>& terms, const std::string& u, Eigen::Index from = 0);

  // The component of each column, for a chain that stands at offset in the problem.
  [[nodiscard]] std::vector<Eigen::Index> components(const Chain& chain, Eigen::Index offset = 0) const;
  // u and u', and -u' times the damping, which is the power that it takes, of all columns of the scene.
  [[nodiscard]] double u(In columns) const { return columns[first]; }
  [[nodiscard]] double du(In columns) const { return columns[first + at_du]; }
  [[nodiscard]] double power(In columns) const;

  Eigen::Index first, at_du = 1;
  std::vector<std::string> names;
  std::vector<double> orders;  // of the columns as derivatives of u
  Vec damping;                 // sum of damping[c] column c: the damping terms
};

}  // namespace fde
