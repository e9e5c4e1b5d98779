// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Why the scheme cannot take the resets of the problem, as part of a sentence; nullopt: it can, or there are
// none.
std::optional<std::string> unsupported_resets_reason(const Scheme& scheme, const Problem& problem);

// Scheme::solve for problems with resets too. The scheme solves for u = y - s(t), where s is the sum of the
// jumps of y before t: u is continuous, D^g u = f(t, u + s(t)), and only f jumps, where the scheme locates a
// switch.
Solve with_resets(Solve solve);

}  // namespace fde
