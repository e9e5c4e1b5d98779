// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace fde::bench {

// The accuracies for which the cheapest run is wanted by default: the targets of the default sweep, and the
// cells of the page.
inline constexpr std::array default_accuracies{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};

}  // namespace fde::bench
