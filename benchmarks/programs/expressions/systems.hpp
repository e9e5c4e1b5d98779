// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// A system as the text of an equation file, and the functions of its problem written by hand.
struct WrittenTwice {
  std::string_view name, file;
  std::function<void(double t, In y, Out f)> rhs;
  // Empty: the problem is linear, and the file gives its matrix.
  std::function<void(double t, In y, OutMatrix jacobian)> jacobian{};
};

const std::vector<WrittenTwice>& systems_written_twice();

}  // namespace fde::bench
