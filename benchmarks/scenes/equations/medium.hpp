#pragma once

#include "scenes/equations/sine_modes.hpp"

namespace fde {

// What a field diffuses through: a(x) in D^gamma u = kappa div(a grad u), which varies with x alone.
class Medium {
 public:
  // By the parameters of medium_parameters().
  explicit Medium(const Parameters& parameters);

  [[nodiscard]] bool even() const { return kind_ == "even"; }  // a = 1
  [[nodiscard]] double at(double x) const;

 private:
  std::string kind_;
  double contrast_;
};

// What both scenes of diffusion ask about it: `medium` and `contrast`.
std::vector<Parameter> medium_parameters();

}  // namespace fde
