// SPDX-License-Identifier: MIT
// Scenes with arbitrary parameters, a few steps of any scheme, and their exact references. The input: a line
// with the id of the scene, one with that of the scheme, then bytes that choose the rest.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fuzz/fuzzing.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

// The entry with this id; for any other text, an entry chosen by its hash.
template <class List>
const auto& named(const List& list, std::string_view id) {
  const auto found = std::ranges::find(list, id, [](const auto& one) { return one.id; });
  if (found != list.end()) return *found;
  return *std::next(list.begin(), std::hash<std::string_view>{}(id) % list.size());
}

double number(fuzz::Bytes& bytes, const Parameter& parameter) {
  const auto& [low, high, open_low, open_high] = parameter.range;
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  switch (bytes.index_below(12)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return std::nextafter(low, high);
    case 3:
      return std::nextafter(high, low);
    case 4:
      return tiny;
    case 5:
      return std::nextafter(1.0, bytes.index_below(2) == 0 ? 0.0 : 2.0);
    case 6:
      return 1e-300;
    case 7:
      return std::pow(10.0, bytes.take<std::int8_t>());
    case 8:
      return 0.01 * bytes.take<std::int8_t>();
    case 9:
      return -std::pow(10.0, bytes.take<std::int8_t>());
    default:
      return bytes.take<double>();
  }
}

ParameterValue value(fuzz::Bytes& bytes, const Parameter& parameter) {
  if (!parameter.choices.empty()) return parameter.choices[bytes.index_below(parameter.choices.size())];
  if (!std::holds_alternative<std::vector<double>>(parameter.value)) return number(bytes, parameter);
  std::vector<double> numbers(bytes.index_below(4));
  for (double& one : numbers) one = number(bytes, parameter);
  return numbers;
}

void solve(const Scene& scene, const Scheme& scheme, const Resolution& resolution) {
  if (const auto reason = unsupported_reason(scheme, scene.problem, resolution)) {
    fuzz::require(!reason->empty(), "a refusal has a reason");
    return;
  }
  const auto path = scheme.solve(scene.problem, resolution, {.budget = 0.5});
  const auto shown = fmt::format("{} {} T = {}", scene.name, scheme.id, scene.problem.end);
  fuzz::require(path.status != SolveStatus::finished || path.y.allFinite(), "what finished is finite", shown);
  fuzz::require(!describe(scene.problem, path).empty(), "an ending has a description", shown);
}

// Closed forms and inverse Laplace transforms; other references take up to minutes.
void check_reference(const Scene& scene, double t) {
  if (!scene.reference.at) return;
  const auto [value, bound] = scene.reference.at(t);
  const auto shown =
      fmt::format("{} t = {}: {} bound {}", scene.name, t, fmt::join(value, " "), fmt::join(bound, " "));
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    const bool known =
        std::isfinite(value[i]);  // otherwise out of the range of double, with an infinite bound
    fuzz::require(known ? bound[i] >= 0.0 : !std::isfinite(bound[i]), "a value has its bound", shown);
  }
}

}  // namespace

FDE_FUZZ_TARGET(parameter_values) {
  fuzz::Bytes bytes(data, size);
  const auto& factory = named(built_in_scenes(), bytes.line());
  const auto& scheme = named(schemes(), bytes.line());
  const int steps = 1 + static_cast<int>(bytes.index_below(24));
  const bool exact = bytes.index_below(4) == 0;
  ParameterValues values;
  while (!bytes.empty() && !factory.parameters.empty()) {
    const auto& parameter = factory.parameters[bytes.index_below(factory.parameters.size())];
    values[parameter.name] = value(bytes, parameter);
  }
  fuzz::require_one_line_errors([&] {
    const Scene scene = make_scene(factory, values);
    if (!scene.ill_posed_reason.empty()) return;
    if (exact) {
      check_reference(scene, scene.problem.end);
    } else if (scheme.capabilities.is_adaptive()) {
      const double error = std::pow(10.0, -steps / 2.0);
      solve(scene, scheme, Tolerance{error, error});
    } else {
      solve(scene, scheme, Grid{.end = scene.problem.end, .steps = steps});
    }
  });
  return 0;
}
