#pragma once

#include <span>
#include <string>
#include <vector>

#include "sweep/sweep.hpp"

namespace fde {

// A scene where schemes break, and how many steps they get; those that choose their steps get an accuracy.
struct Trial {
  std::string kind;  // a heading: "Stiff", "Extreme orders", ...
  SceneVariant scene;
  int steps;
  bool thorough = false;  // takes too long for the default sweep
};

inline constexpr Accuracy trial_accuracy{1e-6, 1e-300};

// All of them, each label once; those of a kind are neighbours.
std::span<const Trial> trials();

// The trials as sweeps with these schemes and means, those with the same number of steps together; the
// thorough ones where they are asked for.
std::vector<Sweep> sweeps_of_trials(Sweep like, bool thorough);

}  // namespace fde
