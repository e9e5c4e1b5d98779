// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/kernel_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fdebench/schemes/history/block_kernels.hpp"
#include "fdebench/schemes/history/weights/exponential_sum.hpp"
#include "fdebench/schemes/history/zero_matrix.hpp"

namespace fde {

ExponentialKernel::ExponentialKernel(long double a, double shortest, double end, double tolerance)
    : exponent(a), gamma_(std::tgamma(static_cast<double>(a) + 1.0)) {
  const auto sum = exponential_sum(a, shortest, 2.0 * end, tolerance);
  const double last = sum.nodes[sum.nodes.size() - 1];
  nodes = padded(sum.nodes, last);
  coefficients = padded(sum.coefficients, 0.0);
  fastest_ = last * shortest;
}

Eigen::Index ExponentialKernel::node_count(double length) const {
  // The error bound of exponential_sum allows to omit the nodes after its last one: one more than up to
  // fastest_.
  const auto slower = std::upper_bound(nodes.begin(), nodes.end(), fastest_ / length) - nodes.begin();
  return std::min(rounded_up(slower + 1), nodes.size());
}

std::array<double, 3> ExponentialKernel::newest_step_integrals(double power) const {
  const auto a = static_cast<double>(exponent);
  const double first = power / gamma_, second = first / (a + 1.0);
  return {first, second, second / (a + 2.0)};
}

KernelIntegrals::KernelIntegrals(ExponentialKernel kernel)
    : kernel_(std::move(kernel)), active_(kernel_.nodes.size()) {}

void KernelIntegrals::begin() {
  polynomials_.setZero(3, functions_);
  make_zero(states_, kernel_.nodes.size(), functions_);
  make_zero(carries_, kernel_.nodes.size(), functions_);
}

// Steps that are equal up to rounding reactivate no exponentials.
Eigen::Index KernelIntegrals::node_count(double length) const {
  constexpr double more_than_rounding = 1.0 + 1e-6;
  const auto count = kernel_.node_count(length);
  return count <= active_ ? count : std::max(active_, kernel_.node_count(length * more_than_rounding));
}

// The states of the exponentials from active_ to count, from the newest step alone.
Matrix KernelIntegrals::reactivated(Eigen::Index count) const {
  const auto rows = count - active_;
  Matrix states = Matrix::Zero(rows, polynomials_.cols()), phi(rows, 3);
  if (rows == 0) return states;
  Vec decay_minus_one(rows);
  phi_functions(rows, length_, kernel_.nodes.data() + active_, phi, decay_minus_one.data());
  multiply_add(rows, phi.cols(), states.cols(), phi, polynomials_, states);
  return states;
}

void KernelIntegrals::prepare(double length, KernelStep& step) const {
  prepare(length, std::pow(length, static_cast<double>(kernel_.exponent)), step);
}

void KernelIntegrals::prepare(double length, double power, KernelStep& step) const {
  const auto size = kernel_.nodes.size();
  step.length = length;
  step.count = node_count(length);
  step.decay_minus_one.resize(size);
  step.phi.resize(size, 3);
  step.weights.resize(size);
  phi_functions(step.count, length, kernel_.nodes.data(), step.phi, step.decay_minus_one.data());
  apply_decay(step.count, kernel_.coefficients.data(), step.decay_minus_one.data(), step.weights.data());
  step.newest_step_integrals = kernel_.newest_step_integrals(power);
  step.reactivated = reactivated(std::max(step.count, active_));
}

double KernelIntegrals::integral(const KernelStep& step, Eigen::Index function,
                                 const Polynomial& newest) const {
  const auto alive = std::min(step.count, active_);
  double far = dot_product(step.weights.data(), states_.col(function).data(), alive);
  if (step.count > alive) {
    far +=
        dot_product(step.weights.data() + alive, step.reactivated.col(function).data(), step.count - alive);
  }
  return far + (newest[0] * step.newest_step_integrals[0] + newest[1] * step.newest_step_integrals[1] +
                newest[2] * step.newest_step_integrals[2]);
}

void KernelIntegrals::advance(const KernelStep& step) {
  if (step.count > active_) {
    states_.middleRows(active_, step.reactivated.rows()) = step.reactivated;
    carries_.middleRows(active_, step.reactivated.rows()).setZero();
  }
  active_ = step.count;
  length_ = step.length;
  advance_integrals(active_, states_.cols(), step.decay_minus_one.data(), step.phi, polynomials_, states_,
                    carries_);
}

std::size_t KernelIntegrals::bytes() const {
  const auto step = (2 + 3) * kernel_.nodes.size();  // doubles of a KernelStep
  const auto doubles = 2 * kernel_.nodes.size() + step + 2 * states_.size() + polynomials_.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

void KernelIntegrals::state(Archive& archive) {
  archive(length_, polynomials_, states_, carries_);
  archive.count(active_, 0, kernel_.nodes.size());
}

}  // namespace fde
