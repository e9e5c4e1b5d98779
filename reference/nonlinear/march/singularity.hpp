// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace fde::reference {

// The solution leaves the domain of its problem before the requested time.
struct Singularity : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fde::reference
