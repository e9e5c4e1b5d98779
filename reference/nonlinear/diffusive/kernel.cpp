// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/diffusive/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fde::reference {

namespace {

// The trapezoidal rule converges like exp(-pi^2 / spacing), with a factor that grows with the requested
// digits.
constexpr long double spacing = 0.24L;
constexpr long double negligible = 45;  // e^-45 = 3e-20

// Below this u the remainder of the integral, s^(1-g) = exp((1-g) (u - e^-u)), is negligible.
long double lowest(double order) { return -std::log(negligible / (1.0L - static_cast<long double>(order))); }

}  // namespace

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
