// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fdebench/benchmarks/expressions/foreign_notation.hpp"
#include "fdebench/benchmarks/expressions/formula_tokens.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"
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
    DepthGuard& operator=(DepthGuard&&) = delete;

   private:
    FormulaParser& reader_;
  };

  [[noreturn]] static void fault(const std::string& what, std::size_t place) {
    throw FormulaError(what, place);
  }
  [[noreturn]] void expected(std::string_view allowed) const {
    fault(token_.text.empty() ? fmt::format("the formula ends, there must be {}", allowed)
                              : fmt::format("'{}': must be {}{}", token_.text, allowed, hint()),
          token_.byte_offset);
  }

  // How to write what begins with this token.
  [[nodiscard]] std::string hint() const {
    const auto& before = previous_.text;
    if (is_function(before) || before == "D")
      return symbol_hint(text_.substr(token_.byte_offset), false, false);
    if (token_.text == "(" && is_name(before)) return hint_of_arguments(before);
    const bool follows_number = !before.empty() && is_digit(before.back()) && !is_name(before);
    return symbol_hint(text_.substr(token_.byte_offset), follows_number,
                       follows_number || is_name(before) || before == ")");
  }

  // The same of the bracket behind the name of an unknown or of a parameter.
  [[nodiscard]] std::string hint_of_arguments(std::string_view name) const {
    const auto first = next_token(text_, token_.byte_offset + 1);
    const auto second = next_token(text_, first.byte_offset + first.text.size());
    if (first.text == "t" && second.text == ")") return fmt::format("; {0}(t) is {0}", name);
    if (first.text == "t" && second.text == "-") {
      return "; earlier values are those of unknowns, in the rhs of equations other than mechanics";
    }
    if (first.text == "0" && second.text == ")")
      return fmt::format("; {}(0) is the number of its key initial: write that, or a parameter", name);
    return fmt::format("; {} is no function, a product needs its '*'", name);
  }

  void advance() {
    previous_ = token_;
    token_ = next_token(text_, token_.byte_offset + token_.text.size());
  }

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
    const auto bound = std::ranges::find(bound_, token.text, &BoundName::name);
    if (bound != bound_.end()) return into_.number(bound->value);
    const auto table =
        std::ranges::find(names_.tables, token.text, [](const auto& one) { return one->name(); });
    const auto function = function_named(token.text);
    if (names_.component && token_.text == "[" && !function && table == names_.tables.end())
      return at_time(component(token), token, true);
    const bool named_alike = token_.text != "(" && is_known(token.text);  // e.g. gamma as an order
    if (table != names_.tables.end() && !named_alike) return sampled(*table, token);
    if (function && !named_alike) return call(*function);
    if (token.text == "pi") return into_.pi();
    if (token_.text == "(" && token.text == "sum" && !is_known("sum")) return sum_of_terms();
    if (names_.resolve) {
      if (const auto known = names_.resolve(token.text)) return at_time(*known, token);
    }
    unknown_name(token);
  }

  [[nodiscard]] bool is_known(std::string_view name) const {
    return names_.resolve && names_.resolve(name).has_value();
  }

  // The value of a formula that is a whole number.
  int whole_number(std::string_view what) {
    constexpr long double largest = 1e9L;
    const FormulaToken first = token_;
    const auto value = into_.value(sum());
    if (!value)
      fault(fmt::format("{}: must be a formula of whole numbers and parameters", what), first.byte_offset);
    if (!(std::abs(*value) <= largest) || *value != std::rint(*value)) {
      fault(fmt::format("{} = {}: must be a whole number", what, static_cast<double>(*value)),
            first.byte_offset);
    }
    return static_cast<int>(*value);
  }

  // The index in square brackets, which come next.
  int index_of(const FormulaToken& vector) {
    advance();
    const int index = whole_number(fmt::format("the index of {}", vector.text));
    if (!take("]")) expected(fmt::format("an operation or ']', as in {}[1]", vector.text));
    return index;
  }

  Expression component(const FormulaToken& vector) {
    const int index = index_of(vector);
    try {
      return names_.component(vector.text, index);
    } catch (const std::invalid_argument& none) {
      fault(none.what(), vector.byte_offset);
    }
  }

  // Up to the bracket that closes the arguments: f of an empty sum may name what there is not.
  void skip_argument() {
    for (int depth = 0; !token_.text.empty() && (depth > 0 || token_.text != ")"); advance()) {
      if (token_.text == "(") ++depth;
      if (token_.text == ")") --depth;
    }
  }

  // sum(j, a, b, f), of which "sum" is read. f is read once for each j, from the same place.
  Expression sum_of_terms() {
    constexpr int most = 100'000;
    constexpr std::string_view form = ", as in sum(j, 1, 3, u[j])";
    advance();
    const FormulaToken name = token_;
    if (!is_name(name.text) || is_symbol(name.text) || is_known(name.text))
      fault(fmt::format("{}: must be a new name{}", name.text, form), name.byte_offset);
    advance();
    const auto next = [&](std::string_view symbol) {
      if (!take(symbol)) expected(fmt::format("'{}'{}", symbol, form));
    };
    next(",");
    const int from = whole_number("the first index of sum");
    next(",");
    const int to = whole_number("the last index of sum");
    if (to - from >= most)
      fault(fmt::format("the sum has {} terms: must be at most {}", to - from + 1, most), name.byte_offset);
    const FormulaToken before = token_;
    Expression total = into_.number(0);
    bound_.push_back({name.text, from});
    if (to < from) skip_argument();
    for (int j = from; j <= to; ++j) {
      bound_.back().value = j;
      token_ = before;
      next(",");
      total = made(Operation::add, total, sum());
    }
    bound_.pop_back();
    next(")");
    return total;
  }

  [[noreturn]] void unknown_name(const FormulaToken& token) const {
    const bool is_call = token_.text == "(" || token_.text == "[";
    auto hint = is_call ? function_hint(token.text) : name_hint(token.text);
    if (hint.empty()) hint = hint_of_derivative(token.text);
    if (hint.empty() && is_call && token.text == "J")
      hint = "; a fractional integral J(f, q) is allowed in the right-hand side of an unknown only";
    if (hint.empty()) {
      auto known = is_call ? function_names() : names_.accepted_names;
      for (const auto& table : names_.tables)
        if (is_call) known.emplace_back(table->name());
      if (!is_call) known.emplace_back("pi");
      hint = fmt::format("{}; there are {}{}", did_you_mean(token.text, known), fmt::join(known, ", "),
                         is_call ? "" : " and functions");
    }
    fault(fmt::format("{}: no such {} here{}", token.text, is_call ? "function" : "name", hint),
          token.byte_offset);
  }

  // Of dx, vx and xdot, where x is an unknown.
  [[nodiscard]] std::string hint_of_derivative(std::string_view name) const {
    constexpr std::array<std::string_view, 3> ends{"_dot", "dot", "p"};
    const auto is_unknown = [&](std::string_view one) {
      return names_.derivative && one != "t" &&
             std::ranges::find(names_.accepted_names, one) != names_.accepted_names.end();
    };
    const auto text = [](std::string_view one) {
      return fmt::format("; the derivative of {0} is D({0}, 1)", one);
    };
    if ((name.starts_with('d') || name.starts_with('v')) && is_unknown(name.substr(1)))
      return text(name.substr(1));
    for (const auto end : ends) {
      const auto begin = name.substr(0, name.size() - std::min(end.size(), name.size()));
      if (name.ends_with(end) && is_unknown(begin)) return text(begin);
    }
    return "";
  }

  Expression call(Operation operation) {
    const auto& function = signature(operation);
    if (token_.text != "(") expected(fmt::format("'(', {} being a function", function.name));
    advance();
    std::array<Expression, 3> arguments{ExpressionPool::none, ExpressionPool::none, ExpressionPool::none};
    for (std::size_t i = 0; i < function.arguments; ++i) {
      arguments[i] = sum();
      const bool is_last = i + 1 == function.arguments;
      if (!take(is_last ? ")" : ",")) {
        const bool is_too_many = is_last && i > 0 && token_.text == ",";
        expected(fmt::format("'{}', {} taking {} argument{}{}", is_last ? ")" : ",", function.name,
                             function.arguments, function.arguments == 1 ? "" : "s",
                             is_too_many ? fmt::format(", as {0}(a, {0}(b, c))", function.name) : ""));
      }
    }
    return made(operation, arguments[0], arguments[1], arguments[2]);
  }

  Expression sampled(const std::shared_ptr<const SampledFunction>& table, const FormulaToken& token) {
    if (!take("(")) expected(fmt::format("'(', {} being a table, as in {}(t)", token.text, token.text));
    const auto value = into_.sampled(table, sum());
    if (!take(")")) expected(fmt::format("')', {} taking 1 argument", token.text));
    if (names_.on_sampled) names_.on_sampled(value, token.byte_offset);
    return value;
  }

  // The value, or, with a time in brackets behind it, the value at that time. x(t) and x(0) are refused with
  // the hint of what to write.
  Expression at_time(Expression value, const FormulaToken& token, bool is_component = false) {
    const bool is_unknown = is_component || into_.depends_on_unknowns(value);
    const auto first = next_token(text_, token_.byte_offset + token_.text.size());
    const auto second = next_token(text_, first.byte_offset + first.text.size());
    const bool is_now_or_start = (first.text == "t" || first.text == "0") && second.text == ")";
    if (token_.text != "(" || !is_unknown || !names_.earlier || is_now_or_start) return value;
    advance();
    const auto time = sum();
    if (!take(")")) expected("')', as in x(t - 1)");
    try {
      return names_.earlier(value, time);
    } catch (const std::invalid_argument& none) {
      fault(fmt::format("{}(...): {}", token.text, none.what()), token.byte_offset);
    }
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
    if (names_.time_derivative && !is_before_comma(unknown)) return time_derivative(token);
    if (!is_letter(unknown.text.empty() ? ' ' : unknown.text.front())) expected("an unknown");
    advance();
    const bool is_component = names_.component && token_.text == "[";
    const std::string name =
        is_component ? fmt::format("{}[{}]", unknown.text, index_of(unknown)) : std::string(unknown.text);
    if (!take(",")) expected("',', as in D(x, 0.5)");
    const FormulaToken first = token_;
    const auto order = sum();
    const FormulaToken second = next_token(text_, first.byte_offset + first.text.size());
    const bool is_decimal = second.byte_offset == token_.byte_offset && !is_letter(first.text.front());
    if (!take(")")) expected("')', as in D(x, 0.5)");
    try {
      return at_time(names_.derivative(name, order, is_decimal), token, is_component);
    } catch (const std::invalid_argument& none) {
      fault(none.what(), token.byte_offset);
    }
  }

  // Whether it is the name of something else than the time, with a comma or an index behind it.
  [[nodiscard]] bool is_before_comma(const FormulaToken& token) const {
    const auto behind = next_token(text_, token.byte_offset + token.text.size()).text;
    return !token.text.empty() && is_letter(token.text.front()) && token.text != "t" &&
           (behind == "," || behind == "[");
  }

  // D(of, order) of a formula, of which "D(" is read.
  Expression time_derivative(const FormulaToken& token) {
    const auto of = sum();
    if (!take(",")) expected("',', as in D(x, 0.5)");
    const auto order = sum();
    if (!take(")")) expected("')', as in D(x, 0.5)");
    try {
      return names_.time_derivative(of, order);
    } catch (const std::invalid_argument& none) {
      fault(none.what(), token.byte_offset);
    }
  }

  std::string_view text_;
  const FormulaNames& names_;
  ExpressionPool& into_;
  FormulaToken token_{}, previous_{};
  int depth_ = 0;
  struct BoundName {
    std::string_view name;
    int value;
  };
  std::vector<BoundName> bound_{};  // of sums, the innermost last
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

bool is_function(std::string_view name) { return function_named(name).has_value(); }

}  // namespace fde::bench
