// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "fdebench/reports/command/command.hpp"

namespace fde::bench {

// The exit code and output of the command, run in this process.
struct CommandOutput {
  int code;
  std::string out, err;
};

inline CommandOutput fdebench(const std::vector<std::string>& arguments,
                              const SceneRegistry& known = built_in_scenes()) {
  std::ostringstream out, err;
  const int code = run_fdebench(arguments, {.out = out, .err = err}, known);
  return {code, out.str(), err.str()};
}

}  // namespace fde::bench
