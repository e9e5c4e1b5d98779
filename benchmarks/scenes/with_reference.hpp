// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The scene with this reference, for an equation file whose exact solution is C++.
SceneFactory with_reference(SceneFactory file,
                            const std::function<reference::Reference(const Parameters&)>& reference);

// The values of a scene's own parameters, from those of a scene that has these and perhaps others.
Parameters parameters_of(const SceneFactory& scene, const Parameters& all);

// The same with one number replaced.
Parameters with_value(const SceneFactory& scene, const Parameters& all, const std::string& name,
                      double value);

}  // namespace fde::bench
