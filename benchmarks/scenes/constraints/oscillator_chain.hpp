// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/mechanics/motion.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// The parameters of a chain of three masses: k, c, q1 ... q3, v1 ... v3, followed by `own`, those of the
// scene.
std::vector<Parameter> chain_parameters(const std::vector<Parameter>& own = {});

// q(0) and v(0). Throws std::invalid_argument if v(0) = 0.
mechanics::InitialState<3> chain_start(const Parameters& p);

}  // namespace fde::bench
