// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/riemann_liouville.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/equation_files/states.hpp"
#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/benchmarks/expressions/formula_tokens.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {
namespace {

using reference::Rational;

constexpr std::size_t most_starting_powers = 200;

// sum of c t^p/Gamma(p + 1): the coefficients c by the powers p.
using Powers = std::map<Rational, Operand>;

// Finds the powers of t that solutions contain beside the parts that have finite right-hand sides.
class StartingPowers {
 public:
  StartingPowers(const EquationText& text, FileFormulas& formulas)
      : text_(text), formulas_(formulas), of_unknown_(text.unknowns.size()), loads_(text.unknowns.size()) {
    for (const auto& unknown : text.unknowns) rhs_.push_back(formulas.read(unknown.rhs, variables()));
    for (std::size_t u = 0; u < text.unknowns.size(); ++u) {
      if (!text.unknowns[u].is_riemann_liouville) continue;
      const Rational order = order_of(u);
      require_initial_values(u, order);
      Rational power = order;
      for (const auto& value : text.unknowns[u].initial) add(u, power -= 1, value_of(value));
    }
    while (const auto next = smallest_load()) {
      const auto [u, power, coefficient] = *next;
      loads_[u].erase(power);
      add(u, Rational(power + order_of(u)),
          coefficient / value_of(text_.unknowns[u].terms.front().coefficient));
    }
    for (const auto& [row, name] : other_values_)
      if (!of_unknown_[row].empty()) formulas_.reject(text_.unknowns[row].rhs, refusal(name));
  }

  [[nodiscard]] const Powers& of(std::size_t unknown) const { return of_unknown_[unknown]; }
  // Those in the right-hand side of its equation.
  [[nodiscard]] const Powers& loads(std::size_t unknown) const { return loads_[unknown]; }

 private:
  struct Load {
    std::size_t unknown;
    Rational power;
    Operand coefficient;
  };

  static std::string refusal(std::string_view what) {
    return fmt::format("{}: must not occur where a Riemann-Liouville derivative makes it infinite at 0",
                       what);
  }

  // Unknown u is variable u + 1.
  FormulaVariables variables() {
    const auto unknown = [this](std::size_t u, double order) {
      if (order != 0.0) other_values_.emplace_back(u, fmt::format("D({}, {})", name(u), order));
      return formulas_.pool().variable(static_cast<int>(u) + 1);
    };
    const auto earlier = [this](Expression of, double lag) {
      for (const int variable : formulas_.pool().variables_in(of)) {
        const auto u = static_cast<std::size_t>(variable) - 1;
        other_values_.emplace_back(u, fmt::format("{}(t - {})", name(u), lag));
      }
      return of;
    };
    return {.time = true, .resolve_unknown = unknown, .earlier = earlier};
  }
  [[nodiscard]] const std::string& name(std::size_t u) const { return text_.unknowns[u].name; }

  Operand value_of(const FormulaText& text) {
    return {&formulas_.pool(), formulas_.read(text, {.time = false})};
  }

  // Precondition: the order of the unknown is above 0.
  void require_initial_values(std::size_t u, const Rational& order) {
    const auto& unknown = text_.unknowns[u];
    const auto needed = initial_count(static_cast<double>(order));
    if (unknown.initial.size() == needed) return;
    reject_at(text_.file, unknown.position,
              fmt::format("unknown {0}: has {1} initial values: must have {2}, those of D({0}, {3} - k) for "
                          "k = 1, ..., {2}",
                          unknown.name, unknown.initial.size(), needed, static_cast<double>(order)));
  }

  // The order of an equation with one term.
  Rational order_of(std::size_t u) {
    const auto& unknown = text_.unknowns[u];
    Rational order = nearest_fraction(value_of(unknown.terms.front().order).value, formulas_.pool());
    if (unknown.terms.size() == 1 && order > 0 && unknown.final.empty()) return order;
    formulas_.reject(unknown.rhs, fmt::format("unknown {}: must have one order above 0, and no final, as its "
                                              "right-hand side is infinite at 0",
                                              unknown.name));
  }

  // Adds a power to an unknown, and what it is in the right-hand sides.
  void add(std::size_t u, const Rational& power, Operand coefficient) {
    if (formulas_.pool().value(coefficient.value) == 0.0L) return;
    add_to(of_unknown_[u], power, coefficient);
    if (of_unknown_[u].size() > most_starting_powers) {
      formulas_.reject(text_.unknowns[u].terms.front().order,
                       "is too small: needs more than 200 powers of t");
    }
    for (std::size_t row = 0; row < rhs_.size(); ++row) {
      const Operand slope = slope_of(row, u);
      if (formulas_.pool().value(slope.value) != 0.0L) add_to(loads_[row], power, slope * coefficient);
    }
  }

  static void add_to(Powers& powers, const Rational& power, Operand coefficient) {
    const auto [known, is_new] = powers.try_emplace(power, coefficient);
    if (!is_new) known->second = known->second + coefficient;
  }

  // df_row/dx_u, which is constant.
  Operand slope_of(std::size_t row, std::size_t u) {
    auto& pool = formulas_.pool();
    const Operand slope{&pool, pool.derivative(rhs_[row], static_cast<int>(u) + 1)};
    if (pool.value(slope.value)) return slope;
    formulas_.reject(text_.unknowns[row].rhs,
                     fmt::format("must be linear in {} with constant coefficients, as a Riemann-Liouville "
                                 "derivative makes it infinite at 0",
                                 name(u)));
  }

  // The smallest power in a right-hand side that is to become a power of the unknown: where the equation has
  // several terms, which have no integral of that kind, only an infinite one.
  std::optional<Load> smallest_load() {
    std::optional<Load> smallest;
    for (std::size_t u = 0; u < loads_.size(); ++u) {
      if (loads_[u].empty()) continue;
      const auto& [power, coefficient] = *loads_[u].begin();
      const int least = text_.unknowns[u].terms.size() == 1 ? 1 : 0;
      if (power < least && (!smallest || power < smallest->power)) smallest = Load{u, power, coefficient};
    }
    return smallest;
  }

  const EquationText& text_;
  FileFormulas& formulas_;
  std::vector<Expression> rhs_{};
  std::vector<std::pair<std::size_t, std::string>> other_values_{};  // derivatives and earlier values
  std::vector<Powers> of_unknown_, loads_;
};

// The time since the start, and all of it up to the end, as formulas.
struct TimeText {
  explicit TimeText(const EquationText& text)
      : since_start(text.start ? fmt::format("(t - ({}))", text.start->text) : "t"),
        whole(text.start ? fmt::format("({} - ({}))", text.end.text, text.start->text)
                         : fmt::format("({})", text.end.text)) {}
  std::string since_start, whole;
};

// The sum over t^divisor as a formula.
std::string sum_text(const Powers& powers, const Rational& divisor, const std::string& t,
                     const ExpressionPool& pool) {
  std::string sum;
  for (const auto& [power, coefficient] : powers) {
    sum += fmt::format("{}({})/gamma({})*{}^({})", sum.empty() ? "" : " + ",
                       formula_text(pool, coefficient.value, {}), Rational(power + 1).str(), t,
                       Rational(power - divisor).str());
  }
  return sum;
}

// The formula with other names.
FormulaText renamed(const FormulaText& formula,
                    const std::map<std::string, std::string, std::less<>>& names) {
  FormulaText result = formula;
  result.text.clear();
  result.pieces.clear();
  std::size_t copied = 0;
  for (auto token = next_token(formula.text, 0); !token.text.empty();
       token = next_token(formula.text, token.byte_offset + token.text.size())) {
    const auto known = names.find(token.text);
    if (known == names.end()) continue;
    result.text += formula.text.substr(copied, token.byte_offset - copied) + known->second;
    copied = token.byte_offset + token.text.size();
  }
  result.text += formula.text.substr(copied);
  return result;
}

// The unknown as an output, the sum of a state and these powers of t. Where it is infinite at t = 0, its
// column is its quotient by a power of t/end, the norm of which is that of weighted spaces of continuous
// functions (Kilbas, Srivastava & Trujillo, Theory and Applications of Fractional Differential Equations,
// 2006, section 3.1).
OutputText output_of(const EquationText& text, const UnknownText& unknown, const Powers& powers,
                     const ExpressionPool& pool) {
  const auto formula = [&](std::string written) {
    return FormulaText{.text = std::move(written), .position = unknown.rhs.position};
  };
  const TimeText time(text);
  const Rational smallest = powers.begin()->first;
  const std::string quotient = sum_text(powers, smallest, time.since_start, pool);
  OutputText output{
      .name = unknown.name,
      .state = free_name(unknown.name + "_state", text.contents),
      .terms = {{formula("1"), formula("0")}},
      .of_time = formula(fmt::format("{}^({})*({})", time.since_start, smallest.str(), quotient))};
  if (smallest >= 0) return output;
  const std::string part = fmt::format("({}/{})", time.since_start, time.whole),
                    root = Rational(-smallest).str();
  output.weighted = {.name = free_name(unknown.name + "_weighted", text.contents),
                     .value = formula(fmt::format("{0}^({1})*{2} + (1/{3})^({1})*({4})", part, root,
                                                  output.state, time.whole, quotient)),
                     .scale = formula(fmt::format("{}^({})", part, smallest.str()))};
  return output;
}

}  // namespace

EquationText with_caputo_derivatives(EquationText text, const Parameters& parameters) {
  const auto is_one = [](const UnknownText& one) { return one.is_riemann_liouville; };
  if (std::ranges::none_of(text.unknowns, is_one)) return text;
  const EquationText given = text;
  FileFormulas formulas(given, parameters, NumberStorage::fractions);
  const StartingPowers powers(given, formulas);
  std::map<std::string, std::string, std::less<>> states;
  for (std::size_t u = 0; u < text.unknowns.size(); ++u) {
    auto& unknown = text.unknowns[u];
    for (auto& value : unknown.initial)
      if (unknown.is_riemann_liouville) value.text = "0";
    if (powers.of(u).empty() || unknown.is_implied) continue;
    if (unknown.name.ends_with(']')) {
      formulas.reject(unknown.rhs,
                      "must not be of a vector, as a Riemann-Liouville derivative makes it infinite at 0");
    }
    text.outputs.push_back(output_of(given, unknown, powers.of(u), formulas.pool()));
    unknown.meaning = state_meaning(unknown.name);
    unknown.name = states[unknown.name] = text.outputs.back().state;
    unknown.is_implied = true;
  }
  for (std::size_t u = 0; u < text.unknowns.size(); ++u) {
    auto& rhs = text.unknowns[u].rhs;
    if (!states.empty()) rhs = renamed(rhs, states);
    if (!powers.loads(u).empty())
      rhs.text += " + " + sum_text(powers.loads(u), 0, TimeText(given).since_start, formulas.pool());
  }
  return text;
}

}  // namespace fde::bench
