// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fdebench/benchmarks/requests/fit.hpp"
#include "fdebench/benchmarks/requests/recommendation.hpp"
#include "fdebench/benchmarks/requests/solve_cost.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// Answers of requests as JSON, for what is printed and for languages with types of their own. docs/command.md
// lists the keys.

// What is unknown is left out.
nlohmann::ordered_json json_of(const SolveCost& cost);

// Precondition: there is an option.
nlohmann::json json_of(const Recommendation& made);

// Names by their meaning, as of the fields of FittedScene.
nlohmann::ordered_json json_of(const FittedScene& fitted);

// What a scene with its default parameters is: id, title, source, parameters with what is allowed, end,
// columns, what it defines, its reference. Many columns u1, u2, ... are a pattern with a range.
nlohmann::ordered_json json_of(const SceneFactory& factory);

// What a scheme is: id, title, source, and what needs_of() has.
nlohmann::ordered_json json_of(const Scheme& scheme);

// What a scheme takes and needs of a problem, by name.
nlohmann::ordered_json needs_of(const Scheme& scheme);

// What a scene defines besides its problem: "exact", "jacobian", "linear", "energy", "constraint".
std::vector<std::string> defined_by(const Scene& scene);

}  // namespace fde::bench
