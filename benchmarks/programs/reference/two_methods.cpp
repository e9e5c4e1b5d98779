// How far the two methods behind the references of nonlinear scenes agree, as CSV; what they cost on standard
// error.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "diffusive/march.hpp"
#include "nonlinear/collocation.hpp"
#include "references/reference_of.hpp"
#include "scenes/registry.hpp"
#include "sweep/experiment.hpp"

namespace fde {
namespace {

constexpr std::array times{1.0, 5.0, 20.0, 50.0};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_rows(const SceneMaker& maker, Scene scene) {
  scene.problem.end = times.back();
  const auto start = std::chrono::steady_clock::now();
  const auto [problem, outputs] = posed_for_reference(scene);
  const Reference reference = reference_solution(problem);  // with its own run of the second method
  const double both = seconds_since(start);
  const auto second = diffusive_solution(problem, {}, {times.begin(), times.end()});
  fmt::print(stderr, "{}: reference {:.2f} s, its second method {:.2f} s in {} steps\n", maker.id, both,
             seconds_since(start) - both, second.times.size());
  for (const double t : times) {
    const ReferenceValue known = reference.at(t);
    const auto k = std::ranges::find(second.times, t) - second.times.begin();
    const Vec values = columns_at(outputs, t, known.value),
              others = columns_at(outputs, t, second.values[static_cast<std::size_t>(k)]);
    const Vec bounds = bound_of_columns(outputs, t, known, values);
    for (Eigen::Index c = 0; c < values.size(); ++c) {
      fmt::print("{},{},{},{:.17g},{:.17g},{:.1e},{:.1e}\n", maker.id, t,
                 scene.outputs.names[static_cast<std::size_t>(c)], values[c], others[c],
                 std::abs(values[c] - others[c]), bounds[c]);
    }
  }
}

}  // namespace
}  // namespace fde

int main() try {
  fmt::print("scene,t,quantity,collocation,second_method,difference,bound\n");
  for (const auto& maker : fde::scenes()) {
    if (auto scene = fde::make_scene(maker); !scene.reference.at) fde::print_rows(maker, std::move(scene));
  }
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 3;
}
