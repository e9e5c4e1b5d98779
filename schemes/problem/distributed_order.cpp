// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/distributed_order.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace fde {
namespace {

constexpr int most_nodes = 40, nodes_of_comparison = 60;

// The symbol sum_k c_k s^(q_k), or the sum of its moduli.
using Symbol = std::complex<double>;
Symbol symbol(const std::vector<Term>& terms, const Symbol& log_s) {
  Symbol sum = 0.0;
  for (const auto& [coefficient, order] : terms) sum += coefficient * std::exp(order * log_s);
  return sum;
}
double size_of_symbol(const std::vector<Term>& terms, const Symbol& log_s) {
  double sum = 0.0;
  for (const auto& [coefficient, order] : terms)
    sum += std::abs(coefficient) * std::exp(order * log_s.real());
  return sum;
}

// The nodes are the eigenvalues of the Jacobi matrix of the Legendre polynomials, the weights follow from its
// eigenvectors (Golub & Welsch, Math. Comp. 23, 1969).
void add_terms(const DistributedOrder& distributed, int nodes, std::vector<Term>& terms) {
  using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using LongVec = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  LongVec beside(nodes - 1);
  for (int k = 1; k < nodes; ++k) beside[k - 1] = k / std::sqrt(4.0L * k * k - 1.0L);
  Eigen::SelfAdjointEigenSolver<LongMatrix> eigen;
  eigen.computeFromTridiagonal(LongVec::Zero(nodes), beside);
  const long double length = static_cast<long double>(distributed.to) - distributed.from;
  for (int k = 0; k < nodes; ++k) {
    const long double part = (1.0L + eigen.eigenvalues()[k]) / 2.0L, first = eigen.eigenvectors()(0, k);
    const auto order = static_cast<double>(distributed.from + length * part);
    const double weight = distributed.weight(order);
    if (!std::isfinite(weight)) throw std::invalid_argument("weight: must be finite between the orders");
    if (weight != 0.0) terms.push_back({static_cast<double>(length * first * first) * weight, order});
  }
}

}  // namespace

std::vector<Term> terms_of(const DistributedOrder& distributed, int nodes) {
  std::vector<Term> terms;
  for (double from = distributed.from; from < distributed.to;) {
    const double to = std::min(distributed.to, std::floor(from) + 1.0);
    add_terms({distributed.weight, from, to}, nodes, terms);
    from = to;
  }
  return terms;
}

int nodes_for(const DistributedOrder& distributed, double end, double tolerance) {
  constexpr double fastest = 1e4, quarter_turn = std::numbers::pi / 2.0;
  const auto exact = terms_of(distributed, nodes_of_comparison);
  if (exact.empty()) throw std::invalid_argument("weight: is 0, must be another function");
  const auto error = [&](int nodes) {
    const auto terms = terms_of(distributed, nodes);
    double largest = 0.0;
    for (const double rate : {1.0, fastest}) {
      for (const double angle : {0.0, quarter_turn}) {
        const Symbol log_s(std::log(rate / end), angle);
        const double off = std::abs(symbol(terms, log_s) - symbol(exact, log_s));
        largest = std::max(largest, off / size_of_symbol(exact, log_s));
      }
    }
    return largest;
  };
  for (int nodes = 2; nodes <= most_nodes; ++nodes)
    if (error(nodes) <= tolerance) return nodes;
  throw std::invalid_argument(fmt::format(
      "weight: {} orders are too few for times up to {}: must be smooth between the orders, or in "
      "parts, one on each side of its jumps and kinks",
      most_nodes, end));
}

}  // namespace fde
