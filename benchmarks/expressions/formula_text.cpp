// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/formula_text.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {
namespace {

// How strongly the outermost operation of a formula binds.
enum class Binding { sum, product, sign, power, single };

struct Text {
  std::string formula{};
  Binding binding = Binding::single;
  [[nodiscard]] std::string in(Binding outer) const {
    return binding < outer ? fmt::format("({})", formula) : formula;
  }
};

Text binary(const Text& a, const Text& b, Operation operation) {
  switch (operation) {
    case Operation::add:
      return {fmt::format("{} + {}", a.in(Binding::sum), b.in(Binding::product)), Binding::sum};
    case Operation::subtract:
      return {fmt::format("{} - {}", a.in(Binding::sum), b.in(Binding::product)), Binding::sum};
    case Operation::multiply:
      if (a.formula == b.formula) return {fmt::format("{}^2", a.in(Binding::single)), Binding::power};
      return {fmt::format("{}*{}", a.in(Binding::product), b.in(Binding::power)), Binding::product};
    case Operation::divide:
      return {fmt::format("{}/{}", a.in(Binding::product), b.in(Binding::power)), Binding::product};
    default:
      return {fmt::format("{}^{}", a.in(Binding::single), b.in(Binding::single)), Binding::power};
  }
}

Text number(const ExpressionPool::Node& entry) {
  const bool is_fraction = entry.text.find('/') != std::string::npos;
  auto text = is_fraction ? entry.text : fmt::format("{}", static_cast<double>(entry.value));
  const auto positive = is_fraction ? Binding::product : Binding::single;
  return {std::move(text), entry.value < 0 ? Binding::sum : positive};
}

Text call(const ExpressionPool::Node& entry, const std::vector<Text>& texts) {
  const auto& function = signature(entry.operation);
  std::string arguments;
  for (std::size_t i = 0; i < function.arguments; ++i)
    arguments += (i > 0 ? "," : "") + texts[static_cast<std::size_t>(entry.arguments[i])].formula;
  return {fmt::format("{}({})", entry.function ? entry.function->name() : function.name, arguments)};
}

}  // namespace

std::string formula_text(const ExpressionPool& pool, Expression of,
                         const std::function<std::string(int variable)>& name) {
  const auto used = pool.subexpressions(of);
  std::vector<Text> texts(used.size());
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (!used[e]) continue;
    const auto& entry = pool[static_cast<Expression>(e)];
    const auto argument = [&](std::size_t i) { return texts[static_cast<std::size_t>(entry.arguments[i])]; };
    switch (entry.operation) {
      case Operation::number:
        texts[e] = number(entry);
        break;
      case Operation::pi:
        texts[e] = {"pi"};
        break;
      case Operation::variable:
        texts[e] = {name(entry.variable)};
        break;
      case Operation::negate:
        texts[e] = {fmt::format("-{}", argument(0).in(Binding::product)), Binding::sum};
        break;
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
      case Operation::divide:
      case Operation::power:
        texts[e] = binary(argument(0), argument(1), entry.operation);
        break;
      default:
        texts[e] = call(entry, texts);
    }
    if (texts[e].formula.size() > max_formula_bytes) return {};
  }
  return texts[static_cast<std::size_t>(of)].formula;
}

}  // namespace fde::bench
