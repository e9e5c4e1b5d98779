#pragma once

#include "mechanics/motion.hpp"
#include "scenes/parameters.hpp"

namespace fde {

// The springs of a chain of three masses and how it starts: k, c, q1 ... q3, v1 ... v3, and behind these what
// a scene has of its own.
std::vector<Parameter> chain_parameters(const std::vector<Parameter>& own = {});

// q(0) and v(0). Throws std::invalid_argument where nothing moves.
mechanics::Motion<3> chain_start(const Parameters& p);

}  // namespace fde
