// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fde::bench::python {

// Runs the command `fdebench` on the streams of the process, as the program does: a wheel has no other.
// Returns its exit code.
int run_program(const std::vector<std::string>& arguments);

}  // namespace fde::bench::python
