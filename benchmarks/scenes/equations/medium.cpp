// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/medium.hpp"

#include <cmath>
#include <numbers>

namespace fde::bench {

Medium::Medium(const Parameters& parameters)
    : kind_(parameters.choice("medium")), contrast_(parameters["contrast"]) {}

double Medium::at(double x) const {
  if (is_uniform()) return 1.0;
  if (kind_ == "halves") return x < 0.5 ? 1.0 : contrast_;
  const double between = std::sin(std::numbers::pi * x);
  return std::pow(contrast_, between * between);
}

std::vector<Parameter> medium_parameters() {
  return {choice("medium", {"even", "wave", "halves"},
                 "a(x) in kappa div(a grad u): 1, contrast^(sin^2 pi x), or 1 below x = 1/2 and contrast "
                 "from there"),
          {"contrast", 10.0, {.low = 1e-6, .high = 1e6}, "of the media that are not even"}};
}

}  // namespace fde::bench
