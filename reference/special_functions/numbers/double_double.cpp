// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/numbers/double_double.hpp"

namespace fde::reference {
namespace {

ElementaryTables make_tables() {
  ElementaryTables tables{};
  const BigReal exponential_step = log(BigReal(2)) / ElementaryTables::exponential_steps;
  const BigReal angle_step = 2 * pi<BigReal>() / ElementaryTables::angles;
  tables.exponential_step = to_double_double(exponential_step);
  tables.angle_step = to_double_double(angle_step);
  const BigReal known = BigReal(tables.angle_step.hi) + tables.angle_step.lo;
  tables.angle_step_rest = BigReal(angle_step - known).convert_to<double>();
  const auto put = [](const BigReal& value, double& hi, double& lo) {
    const DoubleDouble parts = to_double_double(value);
    hi = parts.hi;
    lo = parts.lo;
  };
  for (std::size_t j = 0; j < tables.exponentials_hi.size(); ++j)
    put(exp(BigReal(j * exponential_step)), tables.exponentials_hi[j], tables.exponentials_lo[j]);
  for (std::size_t j = 0; j < tables.cosines_hi.size(); ++j) {
    put(cos(BigReal(j * angle_step)), tables.cosines_hi[j], tables.cosines_lo[j]);
    put(sin(BigReal(j * angle_step)), tables.sines_hi[j], tables.sines_lo[j]);
  }
  return tables;
}

}  // namespace

DoubleDouble to_double_double(const BigReal& x) {
  const auto hi = x.convert_to<double>();
  return {hi, BigReal(x - hi).convert_to<double>()};
}

const ElementaryTables& ElementaryTables::get() {
  constexpr int digits = 60;
  return lazy_table<digits, make_tables>();
}

}  // namespace fde::reference
