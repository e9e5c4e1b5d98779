// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/rounded_number.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace fde::bench {

double rounded(double value, int digits) {
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

}  // namespace fde::bench
