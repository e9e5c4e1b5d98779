// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/distributed_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/schemes/problem/distributed_order.hpp"

namespace fde::bench {
namespace {

constexpr Range lowest_order{.low = 0.0, .high = 10.0},
    highest_order{.low = 0.0, .high = 10.0, .open_low = true};

DistributedOrder distributed_order(const DistributedText& text, FileFormulas& formulas) {
  constexpr int q_variable = 1;
  const auto is_q = [](const ParameterText& one) { return one.declared.name == "q"; };
  if (std::ranges::any_of(formulas.text().parameters, is_q))
    formulas.reject(text.weight, "parameter q: must be another name, q is the order in a weight");
  auto& pool = formulas.pool();
  const auto q = [&](std::string_view name) -> std::optional<Expression> {
    return name == "q" ? std::optional(pool.variable(q_variable)) : std::nullopt;
  };
  const auto weight = formulas.read(text.weight, {.time = false, .resolve_other = q, .other_names = {"q"}});
  const double from = formulas.constant(text.from, "from", lowest_order),
               to = formulas.constant(text.to, "to", highest_order);
  if (!(to > from)) formulas.reject(text.to, fmt::format("to = {}: must be above from = {}", to, from));
  return {.weight = [program = Program(pool, {weight}, 1)](
                        double order) { return program(0.0, Vec::Constant(1, order)); },
          .from = from,
          .to = to};
}

void add_terms(const DistributedText& text, int more_nodes, double end, FileFormulas& formulas,
               UnknownText& unknown) {
  constexpr double tolerance = 1e-10;
  const auto distributed = distributed_order(text, formulas);
  const auto decimal = [&](double value) {
    return FormulaText{.text = fmt::format("{}", value), .position = text.weight.position};
  };
  try {
    const int nodes = nodes_for(distributed, end, tolerance) + more_nodes;
    for (const auto& [coefficient, order] : terms_of(distributed, nodes)) {
      unknown.terms.push_back({decimal(coefficient), decimal(order)});
      unknown.quadrature_orders.push_back(order);
    }
  } catch (const std::invalid_argument& fault) {
    formulas.reject(text.weight, fault.what());
  }
}

}  // namespace

bool has_distributed_orders(const EquationText& text) {
  return std::ranges::any_of(text.unknowns, [](const UnknownText& one) { return !one.distributed.empty(); });
}

EquationText with_quadrature(EquationText text, const Parameters& parameters, const QuadratureNodes& nodes) {
  if (!has_distributed_orders(text)) return text;
  const EquationText given = text;
  FileFormulas formulas(given, parameters, NumberStorage::values);
  const double end = nodes.end.value_or(formulas.end());
  for (auto& unknown : text.unknowns) {
    for (const auto& one : unknown.distributed) {
      if (unknown.factor)
        formulas.reject(*unknown.factor, "factor: must not be given with a distributed order");
      add_terms(one, nodes.more, end, formulas, unknown);
    }
  }
  return text;
}

}  // namespace fde::bench
