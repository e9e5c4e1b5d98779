// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace fde::bench {

// The accuracies for which the page gives the cheapest run.
inline constexpr std::array accuracies{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

}  // namespace fde::bench
