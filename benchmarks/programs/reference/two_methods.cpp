// SPDX-License-Identifier: MIT
// Agreement of the two methods used for the references of nonlinear scenes, as CSV; their times on standard
// error. `fde_figures two_methods --random N` draws N scenes with random parameters and prints a line for
// each whose methods differ by more than the stated bound, and for each without a reference. The exit code is
// 1 in the first case.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"

namespace fde::bench::figures {
namespace {

constexpr std::array compared_times{1.0, 5.0, 20.0, 50.0};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The initial value problems among the nonlinear scenes: problems at both ends have two other methods.
std::vector<const SceneFactory*> nonlinear_scenes() {
  std::vector<const SceneFactory*> found;
  for (const auto& factory : built_in_scenes()) {
    const Scene scene = make_scene(factory);
    if (!scene.reference.at && !is_two_sided(scene.problem)) found.push_back(&factory);
  }
  return found;
}

// Draws each number within a third of its default, if allowed; integers, words and lists keep their defaults.
ParameterValues drawn_values(const SceneFactory& factory, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> factor(2.0 / 3.0, 4.0 / 3.0);
  ParameterValues values;
  for (const Parameter& parameter : factory.parameters) {
    const double* number = std::get_if<double>(&parameter.value);
    if (number == nullptr || !parameter.default_formula.empty() || *number == std::rint(*number)) continue;
    const ParameterValue drawn = std::round(1e4 * factor(generator) * *number) / 1e4;
    if (parameter.allows(drawn)) values[parameter.name] = drawn;
  }
  return values;
}

// The largest difference of the two methods over some times, divided by the stated bound: at most 1 if it
// holds.
double difference_in_bounds(const Problem& problem) {
  std::vector<double> at;
  for (const double part : {0.001, 0.03, 0.2, 0.5, 0.8, 1.0}) at.push_back(part * problem.end);
  const reference::Reference reference = reference::reference_solution(problem);
  const auto second = reference::diffusive_solution(problem, {}, at);
  double largest = 0.0;
  for (const double t : at) {
    const reference::ReferenceValue known = reference.at(t);
    const auto k = std::ranges::find(second.times, t) - second.times.begin();
    const Vec difference = (known.value - second.values[static_cast<std::size_t>(k)]).cwiseAbs();
    const double smallest_bound = std::numeric_limits<double>::min();
    largest = std::max(largest, difference.cwiseQuotient(known.bound.cwiseMax(smallest_bound)).maxCoeff());
  }
  return largest;
}

// The number of `count` random problems whose methods differ by more than the bound.
int random_problems(int count) {
  std::mt19937_64 generator(
      1);  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same problems each time
  const auto factories = nonlinear_scenes();
  std::uniform_real_distribution<double> end(0.3, 10.0);
  int without = 0, beyond = 0;
  for (int i = 0; i < count; ++i) {
    const SceneFactory& factory = *factories[static_cast<std::size_t>(i) % factories.size()];
    const auto values = drawn_values(factory, generator);
    std::string label = factory.id;
    for (const auto& [name, value] : values) label += fmt::format(" {}={}", name, to_text(value));
    try {
      Scene scene = make_scene(factory, values);
      scene.problem.end = end(generator);
      const double difference = difference_in_bounds(reference_problem_of(scene).problem);
      if (difference <= 1.0) continue;
      ++beyond;
      fmt::print("{} until {:.3g}: {:.3g} times the bound\n", label, scene.problem.end, difference);
    } catch (const std::exception& error) {
      ++without;
      fmt::print("{}: {}\n", label, error.what());
    }
  }
  fmt::print("{} of {} problems beyond the bound, {} without a reference\n", beyond, count, without);
  return beyond;
}

void print_rows(const SceneFactory& factory, Scene scene) {
  scene.problem.end = compared_times.back();
  const auto start = std::chrono::steady_clock::now();
  const auto [problem, outputs] = reference_problem_of(scene);
  const reference::Reference reference =
      reference::reference_solution(problem);  // runs the second method too
  const double both = seconds_since(start);
  const auto second =
      reference::diffusive_solution(problem, {}, {compared_times.begin(), compared_times.end()});
  fmt::print(stderr, "{}: reference {:.2f} s, its second method {:.2f} s in {} steps\n", factory.id, both,
             seconds_since(start) - both, second.times.size());
  for (const double t : compared_times) {
    const reference::ReferenceValue known = reference.at(t);
    const auto k = std::ranges::find(second.times, t) - second.times.begin();
    const Vec values = columns_at(outputs, t, known.value),
              others = columns_at(outputs, t, second.values[static_cast<std::size_t>(k)]);
    const Vec bounds = propagated_bound(outputs, t, known, values);
    for (Eigen::Index c = 0; c < values.size(); ++c) {
      fmt::print("{},{},{},{:.17g},{:.17g},{:.1e},{:.1e}\n", factory.id, t,
                 scene.outputs.names[static_cast<std::size_t>(c)], values[c], others[c],
                 std::abs(values[c] - others[c]), bounds[c]);
    }
  }
}

}  // namespace

void two_methods(const Words& words) {
  if (words.size() == 2 && words[0] == "--random") {
    if (random_problems(std::stoi(words[1])) > 0) throw std::runtime_error("the two methods differ");
    return;
  }
  if (!words.empty()) throw std::invalid_argument("two_methods [--random N]");
  fmt::print("scene,t,quantity,collocation,second_method,difference,bound\n");
  for (const auto* factory : nonlinear_scenes()) print_rows(*factory, make_scene(*factory));
}

}  // namespace fde::bench::figures
