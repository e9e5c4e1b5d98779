// SPDX-License-Identifier: MIT
#include <array>

#include "fdebench/benchmarks/reference_data/table_kind.hpp"

namespace fde::bench {

std::span<const TableKind> table_kinds() {
  static const std::array all{mittag_leffler_table, trajectory_table, convergence_table};
  return all;
}

}  // namespace fde::bench
