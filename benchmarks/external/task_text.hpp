#pragma once

#include <string>
#include <vector>

#include "records/setup.hpp"
#include "scenes/variant.hpp"

namespace fde {

// What another program is asked to solve, as JSON: docs/external_solvers.md lists its fields. The scene is
// that of the variant, the times are those at which its columns are wanted.
std::string task_text(const SceneVariant& variant, const Scene& scene, const Setup& setup,
                      const std::vector<double>& times);

}  // namespace fde
