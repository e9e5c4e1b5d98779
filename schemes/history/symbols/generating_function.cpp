// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/generating_function.hpp"

namespace fde {

ComplexValue difference_power(double order, ComplexValue log_zeta) {
  return std::pow(-exp_minus_one(log_zeta), order);
}

ComplexValue generating_function(const WeightTable& table, ComplexValue log_zeta) {
  const ComplexValue regular = regular_part(table, log_zeta);
  if (table.family->acts_on_increments) return difference_power(table.order - 1.0, log_zeta) / regular;
  return difference_power(-table.order, log_zeta) * regular;
}

ComplexValue regular_part(const WeightTable& table, ComplexValue log_zeta) {
  return table.family->regular_part(table.order, log_zeta);
}

}  // namespace fde
