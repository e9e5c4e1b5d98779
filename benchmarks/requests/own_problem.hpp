// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A scene of a problem that another language has posed, with one column per unknown. Its reference is
// computed by two methods at the first evaluation and kept. Throws std::invalid_argument naming the argument
// ("orders", "initial[0]", "end", "names", "jumps"), its value and what is allowed.
Scene own_scene(const Problem& problem, const std::vector<std::string>& names);

// The first of these checks: an order in [0, 2].
void require_order(double order);

// "y" of one unknown, "y1", "y2", ... of more.
std::vector<std::string> usual_names(std::size_t count);

// The id of such a scene in answers.
inline constexpr auto own_id = "problem";

}  // namespace fde::bench
