// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/free_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {
namespace {

const Parameter& declared_parameter(const std::string& name, const SceneFactory& of) {
  try {
    return parameter_named(name, of.id, of.parameters);
  } catch (const std::invalid_argument& unknown) {
    throw Refusal({RequestField{"vary"}, fmt::format(": {}", unknown.what())});
  }
}

double value_of(const std::string& name, const Parameters& values) {
  try {
    return values[name];
  } catch (const std::bad_variant_access&) {
    refuse_value("vary", name, {"a parameter that is one number"});
  }
}

Range within(Range range, const VariedParameter& limits) {
  if (limits.low && *limits.low > range.low) {
    range.low = *limits.low;
    range.open_low = false;
  }
  if (limits.high && *limits.high < range.high) {
    range.high = *limits.high;
    range.open_high = false;
  }
  return range;
}

FreeParameter free_parameter(const VariedParameter& varied, const SceneVariant& scene,
                             const Parameters& values) {
  constexpr double twentieth = 0.05;
  const Range declared = declared_parameter(varied.name, *scene.factory).range;
  const Range range = within(declared, varied);
  const double start = value_of(varied.name, values);
  if (!(range.low < range.high)) {
    const auto limits = fmt::format("{} = {}:{}", varied.name, varied.low.value_or(declared.low),
                                    varied.high.value_or(declared.high));
    refuse_value("vary", limits, {fmt::format("limits LOW < HIGH within its range, {}", declared.text())});
  }
  if (start < range.low || start > range.high) {
    refuse_value("vary", varied.name,
                 {fmt::format("a parameter that starts in its range: it starts at {}, and its range is "
                              "from {} to {}",
                              start, range.low, range.high)});
  }
  FreeParameter made{varied.name, range, start, start == 0.0 ? 1.0 : std::abs(start)};
  const double inside = twentieth * made.variable().width();
  if (start == range.low) made.start += inside;
  if (start == range.high) made.start -= inside;
  return made;
}

}  // namespace

std::vector<FreeParameter> free_parameters(const std::vector<VariedParameter>& vary,
                                           const SceneVariant& scene) {
  if (vary.empty()) refuse_value("vary", "", {"one parameter at least"});
  const Parameters values(scene.factory->id, scene.factory->parameters, scene.values);
  std::vector<FreeParameter> all;
  for (const VariedParameter& varied : vary) {
    if (std::ranges::find(all, varied.name, &FreeParameter::name) != all.end())
      refuse_value("vary", varied.name, {"a parameter that is named once"});
    all.push_back(free_parameter(varied, scene, values));
  }
  return all;
}

}  // namespace fde::bench
