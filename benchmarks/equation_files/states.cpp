// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/states.hpp"

namespace fde::bench {

std::string free_name(std::string name, const std::string& contents) {
  while (contents.find(name) != std::string::npos) name += '_';
  return name;
}

reference::Rational nearest_fraction(Expression of, const ExpressionPool& pool) {
  const auto& node = pool[of];
  if (node.operation == Operation::number && !node.text.empty()) return reference::Rational(node.text);
  return reference::shortest_decimal(static_cast<double>(pool.value(of).value()));
}

}  // namespace fde::bench
