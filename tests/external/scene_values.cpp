// SPDX-License-Identifier: MIT
// scene_values SCENE...: one line of JSON for each scene: its task for an external program, and the
// right-hand side and its derivatives at points near the start.

#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/external/task_text.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace {

using fde::bench::SceneRegistry;
using Json = nlohmann::json;

Json values_at(const fde::Problem& problem, double t, const fde::Vec& y) {
  fde::Vec f(problem.size());
  fde::Matrix jacobian(problem.size(), problem.size());
  problem.rhs(t, y, f);
  fde::evaluate_jacobian(problem, t, y, jacobian);
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const fde::Vec row = jacobian.row(i);
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return {{"t", t},
          {"y", std::vector<double>(y.begin(), y.end())},
          {"rhs", std::vector<double>(f.begin(), f.end())},
          {"jacobian", rows}};
}

Json values_of(const std::string& label, const SceneRegistry& known) {
  constexpr int points = 3;
  constexpr double near = 0.1;
  const auto variant = fde::bench::parse_variant(label, known);
  const auto scene = fde::bench::make_scene(variant);
  std::mt19937 random;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Json all = Json::array();
  for (int i = 0; i < points; ++i) {
    fde::Vec y = fde::taylor_part(scene.problem, 0.0);
    for (auto& value : y) value += near * unit(random) * (1.0 + std::abs(value));
    all.push_back(values_at(scene.problem, scene.problem.end * unit(random), y));
  }
  return {{"task", Json::parse(fde::bench::task_json(variant, scene, {.resolution = 1}, {1.0},
                                                     fde::bench::TaskPurpose::errors))},
          {"points", all}};
}

}  // namespace

int main(int count, char** words) {
  try {
    const auto known = fde::bench::with_equation_files(fde::bench::built_in_scenes());
    for (int i = 1; i < count; ++i) std::cout << values_of(words[i], known).dump() << '\n';
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << '\n';
    return 1;
  }
  return 0;
}
