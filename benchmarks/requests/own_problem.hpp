// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A scene of a problem that another language has posed, with one column per unknown. Its reference is
// computed by two methods at the first evaluation and kept. Throws std::invalid_argument naming the argument
// ("orders", "initial[0]", "end", "names", "jumps", "delays"), its value and what is allowed.
Scene own_scene(const Problem& problem, const std::vector<std::string>& names);

// f(t, y, past) and df/dy of such a problem with delays: past(i, k) is y_i at t - lags[k].
using DelayedFunction = std::function<void(double t, In y, const Matrix& past, Out f)>;
using DelayedJacobian = std::function<void(double t, In y, const Matrix& past, OutMatrix jacobian)>;

// The delays of a problem with this right-hand side. `jacobian` may be empty.
Delays own_delays(const std::vector<double>& lags, const Past& before, const DelayedFunction& f,
                  const DelayedJacobian& jacobian);

// The first of these checks: an order in [0, 2].
void require_order(double order);

// "y" of one unknown, "y1", "y2", ... of more.
std::vector<std::string> usual_names(std::size_t count);

// The id of such a scene in answers.
inline constexpr auto own_id = "problem";

}  // namespace fde::bench
