// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// What a scene with its default parameters is: id, title, source, parameters with what is allowed, end,
// columns, what it defines, its reference. Many columns u1, u2, ... are a pattern with a range.
nlohmann::ordered_json facts_of(const SceneFactory& maker);

// What a scheme is: id, title, source, and what needs_of() has.
nlohmann::ordered_json facts_of(const Scheme& scheme);

// What a scheme takes and needs of a problem, by name.
nlohmann::ordered_json needs_of(const Scheme& scheme);

// What a scene defines besides its problem: "exact", "jacobian", "linear", "energy", "constraint".
std::vector<std::string> defined_by(const Scene& scene);

}  // namespace fde::bench
