// SPDX-License-Identifier: MIT
// The largest stable step of decoupled_multi_order on the damped oscillator's chain (scene damped_oscillator:
// tau = 0.8, lambda = 0.1, w2 = 1), up to 50. CSV, one row a problem:
//
//   alpha, beta    orders of the damping
//   mu, nu         coefficients of the damping
//   step           the largest h such that all step sizes from 1e-5 to h are stable; from 1e-12 or 1e-20 if
//                  1e-5 is unstable

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"

namespace fde::bench::figures {
namespace {

Problem oscillator(double alpha, double beta, double mu, double nu) {
  const auto& factory = built_in_scenes().named("damped_oscillator");
  return make_scene(factory, {{"alpha", alpha}, {"beta", beta}, {"mu", mu}, {"nu", nu}}).problem;
}

double largest_step(const Problem& problem) {
  for (const double shortest : {1e-5, 1e-12, 1e-20}) {
    const double step = largest_stable_step(*find_scheme("decoupled_multi_order"), problem, shortest, 50.0);
    if (step > 0.0) return step;
  }
  throw std::runtime_error("no stable step above 1e-20");
}

}  // namespace

void stability_chain_steps(const Words& /*words*/) {
  fmt::print("alpha,beta,mu,nu,step\n");
  for (const auto& orders : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double mu = std::pow(10.0, 0.5 * i), nu = std::pow(10.0, 0.5 * j);
        const Problem problem = oscillator(orders.first, orders.second, mu, nu);
        fmt::print("{},{},{:.4g},{:.4g},{:.4g}\n", orders.first, orders.second, mu, nu,
                   largest_step(problem));
      }
    }
  }
}

}  // namespace fde::bench::figures
