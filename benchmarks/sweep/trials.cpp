// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/trials.hpp"

#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace fde::bench {
namespace {

std::vector<Trial> all_trials() {
  std::vector<Trial> all;
  const auto add = [&](const std::string& kind, int steps, std::initializer_list<const char*> scenes,
                       bool thorough = false) {
    for (const auto* scene : scenes) all.push_back({kind, parse_variant(scene), steps, thorough});
  };
  add("Stiff", 4096,
      {"stiff_relaxation:lambda=-100", "stiff_relaxation:lambda=-1e4", "stiff_relaxation",
       "stiff_relaxation:lambda=-1e8", "stiff_relaxation:gamma=0.9", "stiff_relaxation:gamma=1.5",
       "stiff_relaxation:lambda=698056.2,im=716043.6", "stiff_relaxation:gamma=0.9,lambda=146567,im=989201",
       "van_der_pol:mu=1", "van_der_pol:mu=10,until=40", "van_der_pol:mu=100,until=100",
       "van_der_pol:mu=1e3,until=1e3", "van_der_pol:mu=1e4", "robertson", "robertson:until=1e3",
       "fractional_diffusion", "extensible_pendulum:K_over_m=1e6,until=1"});
  add("Extreme orders", 4096,
      {"relaxation:gamma=0.01", "relaxation:gamma=0.99", "relaxation:gamma=0.999", "relaxation:gamma=1.001",
       "relaxation:gamma=1.99", "linear_system:gamma1=0.01,gamma2=0.99", "pendulum:alpha=1.99,beta=0.01",
       "brusselator:gamma=0.99,until=10"});
  // Their references take ten seconds each.
  add("Extreme orders", 4096, {"pendulum:alpha=1.001,beta=0.99", "pendulum:alpha=1.999,beta=0.001"}, true);
  add("Solutions like t^0.05 at the start", 4096,
      {"power:gamma=0.05,p=0.05", "relaxation:gamma=0.05", "brusselator:gamma=0.05"});
  add("Extreme magnitudes", 4096,
      {"relaxation:y0=1e150", "relaxation:y0=1e-150", "relaxation:lambda=-1e-150",
       "relaxation:lambda=-1e150"});
  add("Tiny and huge steps", 4096,
      {"relaxation:until=1e-100", "relaxation:until=1e100", "diethelm:until=1e-10"});
  add("Long", 1 << 17,
      {"relaxation:until=1e4", "pendulum:until=1e4", "pendulum:lambda=0,mu=0,nu=0,until=1e4"});
  // The reference of damped_oscillator alone takes a minute.
  add("Long", 1 << 20,
      {"relaxation:until=1e5", "damped_oscillator:until=1e5", "pendulum:until=1e5",
       "pendulum:lambda=0,mu=0,nu=0,until=1e3", "pendulum:lambda=0,mu=0,nu=0,until=1e5"},
      true);
  add("Unstable and singular", 4096,
      {"pendulum:phi0=3.141592653589793",
       "pendulum:lambda=0,mu=0,nu=0,dphi0=0,phi0=3.141592653589793,until=40",
       "fractional_knife_edge:surface=sphere", "fractional_constraint_2d:alpha=1.5",
       "extensible_pendulum:K_over_m=5,g_over_L=0.1,phi0=0,xi0=3"});
  return all;
}

}  // namespace

std::span<const Trial> trials() {
  static const std::vector<Trial> all = all_trials();
  return all;
}

std::vector<Sweep> sweeps_of_trials(Sweep like, bool thorough) {
  std::map<int, Sweep> by_steps;
  like.scenes.clear();
  like.describes_solutions = false;  // the report does not draw them
  if (like.plan.goal) like.repeats = {.most = 1, .min_seconds = 0.0, .attempts = like.repeats.attempts};
  for (const auto& trial : trials()) {
    if (trial.thorough && !thorough) continue;
    auto& sweep = by_steps.try_emplace(trial.steps, like).first->second;
    sweep.plan = {{trial.steps, trial_accuracy}};
    sweep.scenes.push_back(trial.scene);
  }
  std::vector<Sweep> sweeps;
  for (auto& [steps, sweep] : by_steps) sweeps.push_back(std::move(sweep));
  return sweeps;
}

}  // namespace fde::bench
