#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parameters.hpp"
#include "problem.hpp"
#include "smoothness.hpp"
#include "trajectory.hpp"
#include "truth.hpp"

namespace fde {

// The columns a scene shows: components[c] is the component under names[c]; empty: all of them in order.
struct Outputs {
  std::vector<std::string> names{};
  std::vector<Eigen::Index> components{};
};

// E(y) and its exact rate of change along a solution, dE/dt = power(t, y).
struct Energy {
  std::function<double(In y)> value{};
  std::function<double(double t, In y)> power{};
  explicit operator bool() const { return static_cast<bool>(value); }
};

// A problem with what is known about it. What is absent is not computed, stored or shown.
struct Scene {
  std::string name{};  // its id and all parameters, under which its reference is kept; empty: it is not
  Problem problem{};
  Smoothness smoothness{};
  Outputs outputs{};
  Exact exact{};  // of the components
  Energy energy{};
};

// How a scene is made: one file in scenes/ and one line in scenes/list.def.
struct SceneMaker {
  std::string_view id, title, source;
  std::vector<Parameter> parameters;
  std::function<Scene(const Parameters&)> make;
};

// All scenes, in the order of the list.
std::span<const SceneMaker> scenes();

// The scene that a label of results names: "pendulum:alpha=1.9" is a pendulum. nullptr: none does.
const SceneMaker* scene_of_label(std::string_view label);

// The scene's columns of a vector or of rows of components.
Rows shown(const Scene& scene, const Rows& components);

// What is known about the components: scene.exact, or for a scene without one the collocation reference,
// whose bound is an estimate. Computing that takes up to a second, unless it is in the cache_folder().
Exact truth_of(const Scene& scene);

}  // namespace fde
