#include "damping.hpp"

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

Outputs chain_outputs(const Chain& chain, const std::vector<Term>& terms, const std::string& u,
                      Eigen::Index offset) {
  const auto& lower = terms.front();
  const auto& higher = terms.back();
  Outputs columns{.names = {u}, .components = {offset}};
  const auto add = [&](const std::string& name, double order) {
    columns.names.push_back(name);
    columns.components.push_back(offset + *chain.node(order));
  };
  if (lower.coefficient != 0.0) add("Dbeta_" + u, lower.order);
  add("d" + u, 1.0);
  if (higher.coefficient != 0.0) add("Dalpha_" + u, higher.order);
  return columns;
}

}  // namespace fde
