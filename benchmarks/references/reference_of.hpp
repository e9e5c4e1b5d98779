#pragma once

#include <string_view>

#include "scenes/scene.hpp"

namespace fde {

// The problem that a reference is computed of, up to the end of the scene.
PosedProblem posed_for_reference(const Scene& scene);

// What is known about the columns: scene.reference, or for a scene without one what two methods agree on,
// whose bound is an estimate. Computing that takes some seconds, unless it is in the cache_folder(). Throws
// std::runtime_error where there is no reference, with the reason.
Reference reference_of(const Scene& scene);

// What that rests on: "closed form", "inverse Laplace transform" or "two methods".
std::string_view evidence_of(const Scene& scene);

}  // namespace fde
