// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/fit/bounded_variable.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// A parameter that a fit varies, within the range of the parameter and between these limits.
struct VariedParameter {
  std::string name;
  std::optional<double> low{}, high{};
};

// A parameter that a fit varies, with its range and its value where the fit starts. A start at an end of the
// range is moved inside by a twentieth of its width, or of its size.
struct FreeParameter {
  std::string name;
  Range range;
  double start;
  double unit;  // its usual size, above 0

  [[nodiscard]] BoundedVariable variable() const { return {range, unit}; }
};

// Throws Refusal naming `vary`: for none, an unknown one, one that is named twice, is no number, or starts
// outside its range.
std::vector<FreeParameter> free_parameters(const std::vector<VariedParameter>& vary,
                                           const SceneVariant& scene);

}  // namespace fde::bench
