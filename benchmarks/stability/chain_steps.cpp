// The largest stable step of the damped oscillator's chain (scene damped_oscillator: tau = 0.8, lambda = 0.1,
// w2 = 1), up to 50. CSV, one row a problem:
//
//   alpha, beta    orders of the damping
//   mu, nu         its strengths
//   scheme
//   step           the largest h such that all shorter ones, from 1e-5 on, are stable, or from 1e-12 or
//                 1e-20 where that is not; 50: no end found

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiment.hpp"
#include "growing_modes.hpp"

namespace {

using namespace fde;

Problem oscillator(double alpha, double beta, double mu, double nu) {
  const auto maker = std::ranges::find(scenes(), std::string_view("damped_oscillator"), &SceneMaker::id);
  return make_scene(*maker, {{"alpha", alpha}, {"beta", beta}, {"mu", mu}, {"nu", nu}}).problem;
}

double largest_step(std::string_view id, const Problem& problem) {
  for (const double shortest : {1e-5, 1e-12, 1e-20}) {
    const double step = largest_stable_step(*find_scheme(id), problem, shortest, 50.0);
    if (step > 0.0) return step;
  }
  throw std::runtime_error("no stable step above 1e-20");
}

}  // namespace

int main() try {
  fmt::print("alpha,beta,mu,nu,scheme,step\n");
  for (const auto& orders : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double mu = std::pow(10.0, 0.5 * i), nu = std::pow(10.0, 0.5 * j);
        const Problem problem = oscillator(orders.first, orders.second, mu, nu);
        const auto print = [&](std::string_view id) {
          fmt::print("{},{},{:.4g},{:.4g},{},{:.4g}\n", orders.first, orders.second, mu, nu, id,
                     largest_step(id, problem));
        };
        print("decoupled_multi_order");
        if (i % 4 == 0 && j % 4 == 0) print("product_trapezoidal");
      }
    }
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "fde_stability_chain_steps: {}\n", error.what());
  return 1;
}
