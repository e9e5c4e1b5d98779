// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "fdebench/benchmarks/expressions/formula_tokens.hpp"
#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

class FormulaParser {
 public:
  FormulaParser(std::string_view text, const FormulaNames& names, ExpressionPool& into)
      : text_(text), names_(names), into_(into) {
    advance();
  }

  Expression read() {
    const auto whole = sum();
    if (!token_.text.empty()) expected("an operation or the end");
    return whole;
  }

 private:
  // Counts the nesting depth of a formula during its lifetime.
  class DepthGuard {
   public:
    explicit DepthGuard(FormulaParser& reader) : reader_(reader) {
      // The whole formula counts as one level.
      if (++reader_.depth_ > max_nesting_depth + 1) {
        fault(fmt::format("brackets, signs and powers are nested more than {} deep", max_nesting_depth),
              reader_.token_.byte_offset);
      }
    }
    ~DepthGuard() { --reader_.depth_; }
    DepthGuard(const DepthGuard&) = delete;
    DepthGuard& operator=(const DepthGuard&) = delete;

   private:
    FormulaParser& reader_;
  };

  [[noreturn]] static void fault(const std::string& what, std::size_t place) {
    throw FormulaError(what, place);
  }
  [[noreturn]] void expected(std::string_view allowed) const {
    fault(token_.text.empty() ? fmt::format("the formula ends, there must be {}", allowed)
                              : fmt::format("'{}': must be {}", token_.text, allowed),
          token_.byte_offset);
  }

  void advance() { token_ = next_token(text_, token_.byte_offset + token_.text.size()); }

  bool take(std::string_view symbol) {
    if (token_.text != symbol) return false;
    advance();
    return true;
  }
  void require(std::string_view symbol) {
    if (!take(symbol)) expected(fmt::format("an operation or '{}'", symbol));
  }

  Expression made(Operation operation, Expression a, Expression b = ExpressionPool::none,
                  Expression c = ExpressionPool::none) {
    return into_.make_expression(operation, a, b, c);
  }

  Expression sum() {
    auto value = product();
    while (true) {
      if (take("+")) {
        value = made(Operation::add, value, product());
      } else if (take("-")) {
        value = made(Operation::subtract, value, product());
      } else {
        return value;
      }
    }
  }

  Expression product() {
    auto value = signed_power();
    while (true) {
      if (take("*")) {
        if (token_.text == "*") fault("'**': must be '^' for a power", token_.byte_offset);
        value = made(Operation::multiply, value, signed_power());
      } else if (take("/")) {
        value = made(Operation::divide, value, signed_power());
      } else {
        return value;
      }
    }
  }

  Expression signed_power() {
    const DepthGuard deeper(*this);
    if (take("-")) return made(Operation::negate, signed_power());
    if (take("+")) return signed_power();
    const auto base = single();
    return take("^") ? made(Operation::power, base, signed_power()) : base;
  }

  Expression single() {
    if (take("(")) {
      const auto inner = sum();
      require(")");
      return inner;
    }
    const bool is_single =
        !token_.text.empty() && (is_letter(token_.text.front()) || is_digit(token_.text.front()) ||
                                 (token_.text.front() == '.' && token_.text.size() > 1));
    if (!is_single) expected("a number, a name or '('");
    const FormulaToken token = token_;
    advance();
    return is_letter(token.text.front()) ? named(token) : decimal(token);
  }

  Expression decimal(const FormulaToken& token) {
    const std::string text(token.text);
    if (!try_parse_number(text)) {
      fault(fmt::format("{}: {}must be {}", text, double_range_message(text), any_number.text()),
            token.byte_offset);
    }
    return into_.number(text);
  }

  Expression named(const FormulaToken& token) {
    if (token.text == "D") return derivative(token);
    const auto function = std::ranges::find(function_table(), token.text, &FunctionSignature::name);
    const bool named_alike =
        token_.text != "(" && names_.resolve && names_.resolve(token.text);  // e.g. gamma as an order
    if (function != function_table().end() && !named_alike) return call(*function);
    if (token.text == "pi") return into_.pi();
    if (names_.resolve) {
      if (const auto known = names_.resolve(token.text)) return *known;
    }
    unknown_name(token);
  }

  [[noreturn]] void unknown_name(const FormulaToken& token) const {
    if (token.text == "e") fault("e: no such name here; e^x is exp(x)", token.byte_offset);
    auto known = names_.accepted_names;
    known.emplace_back("pi");
    auto nearby = known;
    for (const auto& function : function_table()) nearby.push_back(function.name);
    fault(fmt::format("{}: no such name here{}; there are {} and functions", token.text,
                      did_you_mean(token.text, nearby), fmt::join(known, ", ")),
          token.byte_offset);
  }

  Expression call(const FunctionSignature& function) {
    if (token_.text != "(") expected(fmt::format("'(', {} being a function", function.name));
    advance();
    std::array<Expression, 3> arguments{ExpressionPool::none, ExpressionPool::none, ExpressionPool::none};
    for (std::size_t i = 0; i < function.arguments; ++i) {
      arguments[i] = sum();
      const bool is_last = i + 1 == function.arguments;
      if (!take(is_last ? ")" : ",")) {
        expected(fmt::format("'{}', {} taking {} argument{}", is_last ? ")" : ",", function.name,
                             function.arguments, function.arguments == 1 ? "" : "s"));
      }
    }
    return made(function.operation, arguments[0], arguments[1], arguments[2]);
  }

  Expression derivative(const FormulaToken& token) {
    if (!names_.derivative) fault("D: a derivative is not allowed here", token.byte_offset);
    if (token_.text != "(") expected("'(', as in D(x, 0.5)");
    advance();
    const FormulaToken unknown = token_;
    if (unknown.text == "D") {
      fault("D of D: must be of an unknown; D(D(x, 1), a) from its start is D(x, 1 + a)",
            unknown.byte_offset);
    }
    if (!is_letter(unknown.text.empty() ? ' ' : unknown.text.front())) expected("an unknown");
    advance();
    if (!take(",")) expected("',', as in D(x, 0.5)");
    const FormulaToken first = token_;
    const auto order = sum();
    const FormulaToken second = next_token(text_, first.byte_offset + first.text.size());
    const bool is_decimal = second.byte_offset == token_.byte_offset && !is_letter(first.text.front());
    if (!take(")")) expected("')', as in D(x, 0.5)");
    try {
      return names_.derivative(unknown.text, order, is_decimal);
    } catch (const std::invalid_argument& none) {
      fault(none.what(), token.byte_offset);
    }
  }

  std::string_view text_;
  const FormulaNames& names_;
  ExpressionPool& into_;
  FormulaToken token_{};
  int depth_ = 0;
};

}  // namespace

Expression read_formula(std::string_view text, const FormulaNames& names, ExpressionPool& into) {
  if (text.size() > max_formula_bytes) {
    throw FormulaError(
        fmt::format("the formula has {} bytes: must be at most {}", text.size(), max_formula_bytes), 0);
  }
  return FormulaParser(text, names, into).read();
}

bool is_name(std::string_view text) {
  constexpr std::size_t longest = 64;
  return !text.empty() && text.size() <= longest && is_letter(text.front()) &&
         std::ranges::all_of(text, is_in_name);
}

bool is_symbol(std::string_view name) { return name == "t" || name == "D" || name == "pi"; }

bool is_function(std::string_view name) {
  return std::ranges::find(function_table(), name, &FunctionSignature::name) != function_table().end();
}

}  // namespace fde::bench
