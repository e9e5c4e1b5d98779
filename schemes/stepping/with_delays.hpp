// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Why the scheme cannot take the delays of the problem with this resolution, as part of a sentence; nullopt:
// it can, or there are none.
std::optional<std::string> unsupported_delays_reason(const Scheme& scheme, const Problem& problem,
                                                     const Resolution& resolution);

// Scheme::solve for problems with delays too: the scheme is given a BoundProblem that looks up earlier values
// in its own run.
Solve with_delays(Solve solve);

}  // namespace fde
