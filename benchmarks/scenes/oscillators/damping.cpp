#include "scenes/oscillators/damping.hpp"

#include <cmath>

namespace fde {

std::vector<Term> damping_terms(const Parameters& p, double mu, double lambda, double nu) {
  const double tau = p["tau"], alpha = p["alpha"], beta = p["beta"];
  return {{nu * std::pow(tau, beta), beta}, {lambda * tau, 1.0}, {mu * std::pow(tau, alpha), alpha}};
}

std::vector<Parameter> damping_parameters() {
  return {{"alpha", 1.5, {.low = 1.0, .high = 2.0, .open_high = true}, "higher order of damping"},
          {"beta", 0.5, {.low = 0.0, .high = 1.0}, "lower order of damping"},
          {"tau", 0.8, positive, "relaxation time"}};
}

DampedColumns::DampedColumns(const std::vector<Term>& terms, const std::string& u, Eigen::Index from)
    : first(from) {
  std::vector<double> coefficients;
  const auto add = [&](const std::string& name, double order, double coefficient) {
    names.push_back(name);
    orders.push_back(order);
    coefficients.push_back(coefficient);
  };
  const auto &lower = terms.front(), &middle = terms[1], &higher = terms.back();
  add(u, 0.0, 0.0);
  if (lower.coefficient != 0.0) add("Dbeta_" + u, lower.order, lower.coefficient);
  at_du = std::ssize(names);
  add("d" + u, 1.0, middle.coefficient);
  if (higher.coefficient != 0.0) add("Dalpha_" + u, higher.order, higher.coefficient);
  damping = Eigen::Map<const Vec>(coefficients.data(), std::ssize(coefficients));
}

std::vector<Eigen::Index> DampedColumns::components(const Chain& chain, Eigen::Index offset) const {
  std::vector<Eigen::Index> components;
  for (const double order : orders) components.push_back(offset + *chain.node(order));
  return components;
}

double DampedColumns::power(In columns) const {
  return -du(columns) * damping.dot(columns.segment(first, damping.size()));
}

}  // namespace fde
