// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"

namespace fde::bench {

// The coefficient a(x) of diffusion in D^gamma u = kappa div(a grad u); it depends on x only.
class Medium {
 public:
  // From the parameters of medium_parameters().
  explicit Medium(const Parameters& parameters);

  [[nodiscard]] bool is_uniform() const { return kind_ == "even"; }  // a = 1
  [[nodiscard]] double at(double x) const;

 private:
  std::string kind_;
  double contrast_;
};

// The parameters `medium` and `contrast` of the diffusion scenes.
std::vector<Parameter> medium_parameters();

}  // namespace fde::bench
