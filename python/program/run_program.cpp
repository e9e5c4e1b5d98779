// SPDX-License-Identifier: MIT
#include "fdebench/python/program/run_program.hpp"

#include <iostream>

#include "fdebench/reports/command/command.hpp"

namespace fde::bench::python {

int run_program(const std::vector<std::string>& arguments) {
  return run_fdebench(arguments, {.out = std::cout, .err = std::cerr});
}

}  // namespace fde::bench::python
