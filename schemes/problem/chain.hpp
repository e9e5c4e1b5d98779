#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"
#include "problem/smoothness.hpp"

namespace fde {

// The chain of links of a multi-term equation
//   a D^leading u + factor * sum_k c_k D^(a_k) u = force        (Yin, Liu & Anh 2007, eqs 1.1, 2.1, 3.9)
// Its nodes are 0, the orders a_k and the whole orders below leading, increasing; component i is D^(node i) u
// and link i has order node i+1 - node i. Terms with coefficient 0 are dropped first; whole orders stay, they
// carry initial values.
class Chain {
 public:
  // initial[k] = u^(k)(0) for k < ceil(leading). Throws std::invalid_argument when a term's order is outside
  // [0, leading) or the coefficient of D^leading u is 0.
  Chain(Term leading, const std::vector<Term>& terms, std::vector<double> initial);

  // The links as components: initial values at the whole nodes, 0 elsewhere (eq. 2.2).
  [[nodiscard]] std::vector<Component> components() const;
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(nodes_.size()); }

  // nodes()[i] is the order of component i as a derivative of u.
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }

  // The component that is D^order u; nullopt: no such node.
  [[nodiscard]] std::optional<Eigen::Index> node(double order) const;

  // sum_k c_k D^(a_k) u, y the chain's components.
  [[nodiscard]] double terms(In y) const;

  // D^leading u of the equation above.
  [[nodiscard]] double highest(In y, double force, double factor = 1.0) const;

  // f of all links: f_i = y_{i+1}, the last one the given D^leading u.
  static void links(In y, double highest, Out f);

  // d links / dy for a linear force = stiffness * u + (function of t) and factor 1: A of the problem's
  // linear_part.
  [[nodiscard]] Matrix linear_part(double stiffness) const;

  // d highest / dy for a force with the given derivative by u.
  void highest_gradient(double force_by_u, double factor, Out gradient) const;

 private:
  friend Smoothness chain_smoothness(const std::vector<Chain>& chains);

  Term leading_;
  std::vector<double> nodes_, initial_;
  Vec coefficients_;  // of each node's component
};

// How the components of chains start that drive each other through smooth forces, one chain after the other.
// All chains have the same leading order.
Smoothness chain_smoothness(const std::vector<Chain>& chains);

}  // namespace fde
