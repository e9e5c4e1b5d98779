// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/diffusive/memory.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fde::reference {

namespace {

bool twice(const Component& component) { return component.order > 1.0; }
double part(const Component& component) { return twice(component) ? component.order - 1.0 : component.order; }

// The distinct orders of the memory variables, without 1, which is a plain integral.
std::vector<double> memory_orders(const Problem& problem) {
  std::vector<double> orders;
  for (const Component& component : problem.components) {
    const double order = part(component);
    if (order < 1.0 && !is_algebraic(component) && std::ranges::find(orders, order) == orders.end()) {
      orders.push_back(order);
    }
  }
  return orders;
}

// The trapezoidal rule converges like exp(-pi^2 / spacing), with a factor that grows with the requested
// digits.
constexpr long double spacing = 0.24L;
constexpr long double negligible = 45;  // e^-45 = 3e-20

// Below this u the remainder of the integral, s^(1-g) = exp((1-g) (u - e^-u)), is negligible.
long double lowest(double order) { return -std::log(negligible / (1.0L - static_cast<long double>(order))); }

}  // namespace

MemoryStep::MemoryStep(const DiffusiveKernels& kernels, const RadauRule& rule, double length) {
  const Eigen::Index stages = rule.nodes.size(), count = kernels.rates.size();
  const StageMatrix one = StageMatrix::Identity(stages, stages);
  const StageMatrix step = static_cast<long double>(length) * rule.integral;
  std::vector<StageMatrix> sums;
  for (const auto& kernel : kernels.kernels) {
    sums.emplace_back(static_cast<long double>(kernel.lumped) * one);
  }
  carry.resize(stages, count);
  gain.resize(count, stages);
  decay.resize(count);
  for (Eigen::Index m = 0; m < count; ++m) {
    const StageMatrix response = (one + kernels.rates[m] * step).partialPivLu().solve(step);
    const Stages lost = kernels.rates[m] * response.rowwise().sum();
    carry.col(m) = (Stages::Ones(stages) - lost).cast<double>();
    gain.row(m) = response.row(stages - 1).cast<double>();
    decay[m] = static_cast<double>(lost[stages - 1]);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k] += static_cast<long double>(kernels.kernels[k].weights[m]) * response;
    }
  }
  for (const StageMatrix& sum : sums) {
    local.emplace_back(sum.cast<double>());
  }
  integral = step.cast<double>();
}

MemoryVariables::MemoryVariables(const Problem& problem, RadauRule rule, double shortest)
    : rule_(std::move(rule)), kernels_(memory_orders(problem), problem.end, shortest) {
  for (const Component& component : problem.components) {
    State state{.kernel = -1,
                .algebraic = is_algebraic(component),
                .order_above_one = twice(component),
                .initial = component.initial.back(),
                .memory = {},
                .integral = {}};
    const auto& kernels = kernels_.kernels;
    const auto kernel = std::ranges::find(kernels, part(component), &DiffusiveKernels::Kernel::order);
    const bool plain = kernel == kernels.end();
    if (!plain) {
      state.kernel = kernel - kernels.begin();
    }
    const Vec none = Vec::Zero(plain ? 1 : kernels_.rates.size());
    state.memory = {none, none};
    state.integral = {Vec::Constant(1, component.initial.front()), Vec::Zero(1)};
    states_.push_back(std::move(state));
  }
}

void MemoryVariables::CompensatedSum::add(const Vec& terms) {
  const Vec all = terms + compensation;
  const Vec sum = value + all;
  compensation = all - (sum - value);
  value = sum;
}

const MemoryStep& MemoryVariables::step(double length) {
  auto known = steps_.find(length);
  if (known == steps_.end()) {
    known = steps_.emplace(length, MemoryStep(kernels_, rule_, length)).first;
  }
  return known->second;
}

// The history term of v at the stages.
Vec MemoryVariables::carried(const State& state, const MemoryStep& step) const {
  if (state.kernel < 0) {
    return Vec::Constant(rule_.nodes.size(), state.initial + state.memory.value[0]);
  }
  const Vec& weights = kernels_.kernels[static_cast<std::size_t>(state.kernel)].weights;
  return (step.carry * weights.cwiseProduct(state.memory.value)).array() + state.initial;
}

const Matrix& MemoryVariables::local(const State& state, const MemoryStep& step) {
  return state.kernel < 0 ? step.integral : step.local[static_cast<std::size_t>(state.kernel)];
}

Matrix MemoryVariables::history_term(double length) {
  const MemoryStep& of_step = step(length);
  Matrix all(rule_.nodes.size(), static_cast<Eigen::Index>(states_.size()));
  Eigen::Index i = 0;
  for (const State& state : states_) {
    const Vec v = carried(state, of_step);
    all.col(i++) = state.order_above_one ? Vec((of_step.integral * v).array() + state.integral.value[0]) : v;
  }
  return all;
}

Matrix MemoryVariables::weights(Eigen::Index component, double length) {
  const MemoryStep& of_step = step(length);
  const State& state = states_[static_cast<std::size_t>(component)];
  if (state.algebraic) return Matrix::Identity(rule_.nodes.size(), rule_.nodes.size());
  return state.order_above_one ? Matrix(of_step.integral * local(state, of_step)) : local(state, of_step);
}

void MemoryVariables::advance(double length, const Matrix& rhs) {
  const MemoryStep& of_step = step(length);
  Eigen::Index i = 0;
  for (State& state : states_) {
    const Vec f = rhs.col(i++);
    if (state.algebraic) continue;
    if (state.order_above_one) {
      const Vec v = carried(state, of_step) + local(state, of_step) * f;
      state.integral.add(of_step.integral.bottomRows<1>() * v);
    }
    if (state.kernel < 0) {
      state.memory.add(of_step.integral.bottomRows<1>() * f);
    } else {
      state.memory.add(of_step.gain * f - of_step.decay.cwiseProduct(state.memory.value));
    }
  }
}

void MemoryVariables::add_jump(In jump) {
  Eigen::Index i = 0;
  for (State& state : states_) {
    const double of_y = jump[i++];
    if (state.order_above_one) {
      state.integral.add(Vec::Constant(1, of_y));
    } else {
      state.initial += of_y;
    }
  }
}

DiffusiveKernels::DiffusiveKernels(const std::vector<double>& orders, double end, double shortest) {
  if (orders.empty()) {
    return;
  }
  const auto first = static_cast<long>(std::floor(lowest(*std::ranges::max_element(orders)) / spacing));
  const auto last =
      static_cast<long>(std::ceil(std::log(negligible / static_cast<long double>(shortest)) / spacing));
  const Eigen::Index count = last - first + 1;
  const auto log_rate = [&](long k) {
    const long double u = spacing * static_cast<long double>(k);
    return u - std::exp(-u);
  };
  const long double log_end = std::log(static_cast<long double>(end));
  rates.resize(count);
  for (long k = first; k <= last; ++k) {
    rates[k - first] = std::exp(log_rate(k) - log_end);
  }
  for (const double order : orders) {
    const auto g = static_cast<long double>(order);
    const long double factor = spacing * std::sin(std::numbers::pi_v<long double> * std::min(g, 1 - g)) /
                               std::numbers::pi_v<long double>;
    Kernel kernel{order, Eigen::VectorXd(count), 0.0};
    for (long k = first; k <= last; ++k) {
      const long double u = spacing * static_cast<long double>(k);
      kernel.weights[k - first] =
          static_cast<double>(factor * (1 + std::exp(-u)) * std::exp((1 - g) * (log_rate(k) - log_end)));
    }
    // From the next u on, s = e^u / end up to rounding: a geometric series.
    const long double next = std::exp(-g * (log_rate(last + 1) - log_end));
    kernel.lumped = static_cast<double>(factor * next / -std::expm1(-g * spacing));
    kernels.push_back(std::move(kernel));
  }
}

}  // namespace fde::reference
