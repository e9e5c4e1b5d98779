// The largest stable step of the damped oscillator's chain (scene damped_oscillator: tau = 0.8, lambda = 0.1,
// w2 = 1), up to 50. CSV, one row a problem:
//
//   alpha, beta    orders of the damping
//   mu, nu         its strengths
//   scheme
//   step           the largest h such that all shorter ones, from 0.02 on, are stable; 50: no end found

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiment.hpp"
#include "growing_modes.hpp"

namespace {

using namespace fde;

Problem oscillator(double alpha, double beta, double mu, double nu) {
  const auto maker = std::ranges::find(scenes(), std::string_view("damped_oscillator"), &SceneMaker::id);
  return make_scene(*maker, {{"alpha", alpha}, {"beta", beta}, {"mu", mu}, {"nu", nu}}).problem;
}

}  // namespace

int main() try {
  constexpr double shortest = 0.02, longest = 50.0;
  fmt::print("alpha,beta,mu,nu,scheme,step\n");
  for (const auto& orders : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double mu = std::pow(10.0, 0.5 * i), nu = std::pow(10.0, 0.5 * j);
        const Problem problem = oscillator(orders.first, orders.second, mu, nu);
        const auto print = [&](std::string_view id) {
          fmt::print("{},{},{:.4g},{:.4g},{},{:.4g}\n", orders.first, orders.second, mu, nu, id,
                     largest_stable_step(*find_scheme(id), problem, shortest, longest));
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
