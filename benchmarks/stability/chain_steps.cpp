// The largest stable step of the damped oscillator's chain (scene damped_oscillator: tau = 0.8, lambda = 0.1,
// w2 = 1), up to 100. CSV, one row a problem:
//
//   alpha, beta    orders of the damping
//   mu, nu         its strengths
//   scheme
//   step           the largest h such that all shorter ones, from 1e-4 on, are stable; 100: no end found

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "growing_modes.hpp"
#include "experiment.hpp"

namespace {

using namespace fde;

Problem oscillator(double alpha, double beta, double mu, double nu) {
  const auto maker = std::ranges::find(scenes(), std::string_view("damped_oscillator"), &SceneMaker::id);
  return make_scene(*maker, {{"alpha", alpha}, {"beta", beta}, {"mu", mu}, {"nu", nu}}).problem;
}

}  // namespace

int main() try {
  constexpr double shortest = 1e-4, longest = 100.0;
  fmt::print("alpha,beta,mu,nu,scheme,step\n");
  for (const auto& orders : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    for (int i = -6; i <= 6; ++i) {
      for (int j = -6; j <= 6; ++j) {
        const double mu = std::pow(10.0, i / 3.0), nu = std::pow(10.0, j / 3.0);
        const Problem problem = oscillator(orders.first, orders.second, mu, nu);
        for (const auto* id : {"decoupled_multi_order", "product_trapezoidal"}) {
          fmt::print("{},{},{:.4g},{:.4g},{},{:.4g}\n", orders.first, orders.second, mu, nu, id,
                     largest_stable_step(*find_scheme(id), problem, shortest, longest));
        }
      }
    }
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "fde_stability_chain_steps: {}\n", error.what());
  return 1;
}
