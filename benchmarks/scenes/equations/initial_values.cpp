// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/equations/initial_values.hpp"

#include <fmt/format.h>

namespace fde::bench {

std::vector<double> initial_values(const Parameters& p, std::string_view order, std::string_view value,
                                   std::string_view slope) {
  if (p[order] > 1.0) return {p[value], p[slope]};
  if (p[slope] != 0.0) reject(slope, p[slope], fmt::format("0 when {} is at most 1", order));
  return {p[value]};
}

}  // namespace fde::bench
