// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/implied_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/expressions/formula_tokens.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

// Bytes from `first` up to `last` of a formula without blanks before them, with their places in the file.
FormulaText part_of(const FormulaText& formula, std::size_t first, std::size_t last) {
  first = std::min(last, next_token(formula.text, first).byte_offset);
  FormulaText part{.text = formula.text.substr(first, last - first),
                   .position = position_of(formula, first),
                   .index = formula.index,
                   .size = formula.size};
  part.pieces.push_back({0, part.position});
  for (const LinePiece& piece : formula.pieces) {
    if (piece.first > first && piece.first < last)
      part.pieces.push_back({piece.first - first, piece.position});
  }
  return part;
}

void append(FormulaText& to, const FormulaText& more) {
  for (const LinePiece& piece : more.pieces)
    to.pieces.push_back({to.text.size() + piece.first, piece.position});
  to.text += more.text;
}

// J(f, q) or D(g, q): where its name begins, its brackets and its last comma stand.
struct Call {
  std::size_t name, open, comma, close;
};

// The call whose bracket opens here; nullopt where it does not close or has no comma, which the reader of
// formulas refuses.
std::optional<Call> call_at(const std::string& text, std::size_t name, std::size_t open) {
  std::optional<std::size_t> comma;
  int depth = 0;
  for (auto token = next_token(text, open); !token.text.empty();
       token = next_token(text, token.byte_offset + token.text.size())) {
    if (token.text == "(") ++depth;
    if (token.text == "," && depth == 1) comma = token.byte_offset;
    if (token.text != ")" || --depth > 0) continue;
    return comma ? std::optional(Call{name, open, *comma, token.byte_offset}) : std::nullopt;
  }
  return std::nullopt;
}

// The first call that begins at or after this byte.
std::optional<Call> next_call(const std::string& text, std::size_t from) {
  for (auto token = next_token(text, from); !token.text.empty();) {
    const auto following = next_token(text, token.byte_offset + token.text.size());
    if ((token.text == "J" || token.text == "D") && following.text == "(") {
      if (const auto call = call_at(text, token.byte_offset, following.byte_offset)) return call;
    }
    token = following;
  }
  return std::nullopt;
}

// The call as it is in the file, where that is short and on one line.
std::string meaning_of(const std::string& text, const Call& call) {
  constexpr std::size_t longest = 60;
  auto written = text.substr(call.name, call.close + 1 - call.name);
  const bool fits = written.size() <= longest && is_printable(written);
  return fits ? written
              : fmt::format("{}(..., {})", text[call.name],
                            trimmed(text.substr(call.comma + 1, call.close - call.comma - 1)));
}

// A name, also with an index behind it, as u[i - 1].
bool is_single_name(const std::string& text) {
  const auto token = next_token(text, 0);
  const auto behind = next_token(text, token.byte_offset + token.text.size()).text;
  return !token.text.empty() && is_letter(token.text.front()) && token.text != "t" &&
         (behind.empty() || behind == "[");
}

class ImpliedRows {
 public:
  ImpliedRows(EquationText text, const Parameters& parameters)
      : text_(std::move(text)),
        has_own_j_(std::ranges::find(text_.unknowns, "J", &UnknownText::name) != text_.unknowns.end()),
        formulas_(text_, parameters, NumberStorage::values) {}

  EquationText complete() {
    EquationText complete = text_;
    for (std::size_t i = 0; i < text_.unknowns.size(); ++i)
      complete.unknowns[i].rhs = with_rows(text_.unknowns[i].rhs);
    std::ranges::move(rows_, std::back_inserter(complete.unknowns));
    return complete;
  }

 private:
  // The formula in which rows stand for integrals and derivatives.
  FormulaText with_rows(const FormulaText& formula) {
    FormulaText result{.position = formula.position, .index = formula.index, .size = formula.size};
    std::size_t copied = 0, next = 0;
    while (const auto call = next_call(formula.text, next)) {
      const auto of = part_of(formula, call->open + 1, call->comma),
                 order = part_of(formula, call->comma + 1, call->close);
      next = call->open;
      const auto row =
          formula.text[call->name] == 'J'
              ? integral(with_rows(of), order, meaning_of(formula.text, *call))
              : derivative(of, order, meaning_of(formula.text, *call), position_of(formula, call->name));
      if (!row) continue;
      append(result, part_of(formula, copied, call->name));
      append(result, {.text = *row, .position = {}, .pieces = {{0, position_of(formula, call->name)}}});
      copied = next = call->close + 1;
    }
    append(result, part_of(formula, copied, formula.text.size()));
    return result;
  }

  // nullopt: J is an unknown.
  std::optional<std::string> integral(const FormulaText& of, const FormulaText& order, std::string meaning) {
    if (has_own_j_) return std::nullopt;
    const double q = formulas_.constant(order, "order of J", integral_orders);
    return row({order, of, static_cast<std::size_t>(std::ceil(q)), std::move(meaning)});
  }

  // nullopt: of an unknown, or of a whole order.
  std::optional<std::string> derivative(const FormulaText& of, const FormulaText& order, std::string meaning,
                                        const TextPosition& place) {
    if (is_single_name(of.text)) return std::nullopt;
    const double q = formulas_.constant(order, "order of D", derivative_orders);
    if (q == std::floor(q)) return std::nullopt;
    const auto whole = static_cast<int>(std::ceil(q));
    FormulaText row_order = order, rhs = of;
    row_order.text = fmt::format("{} - ({})", whole, order.text);
    row_order.pieces.clear();
    rhs.text = fmt::format("D({}, {})", of.text, whole);
    for (LinePiece& piece : rhs.pieces) piece.first += 2;  // behind "D("
    rhs.position = place;
    rhs.pieces.insert(rhs.pieces.begin(), {0, place});
    return row({row_order, rhs, 1, std::move(meaning)});
  }

  struct Row {
    FormulaText order, rhs;
    std::size_t initial_values;
    std::string meaning;
  };

  // The name of a row, which may be there already.
  std::string row(const Row& of) {
    const auto is_same = [&](const UnknownText& one) {
      return one.rhs.text == of.rhs.text && one.terms.front().order.text == of.order.text &&
             one.rhs.index == of.rhs.index && one.rhs.size == of.rhs.size;
    };
    if (const auto known = std::ranges::find_if(rows_, is_same); known != rows_.end()) return known->name;
    const auto most = text_.vectors.empty() ? max_unknowns : max_components;
    if (text_.unknowns.size() + rows_.size() >= most) {
      reject_at(text_.file, of.rhs.position,
                fmt::format("there are more than {} unknowns and integrals", most));
    }
    const FormulaText one{.text = "1", .position = of.order.position},
        zero{.text = "0", .position = of.order.position};
    rows_.push_back({.name = free_name(),
                     .position = of.order.position,
                     .terms = {{one, of.order}},
                     .rhs = of.rhs,
                     .initial = std::vector<FormulaText>(of.initial_values, zero),
                     .is_implied = true,
                     .meaning = of.meaning});
    return rows_.back().name;
  }

  // One that nothing in the file has.
  std::string free_name() {
    const auto is_taken = [&](const std::string& name) {
      return text_.contents.find(name) != std::string::npos;
    };
    std::string name;
    do {
      name = fmt::format("integral_{}", ++last_number_);
    } while (is_taken(name));
    return name;
  }

  static constexpr Range integral_orders{.low = 0.0, .high = 10.0, .open_low = true};
  static constexpr Range derivative_orders{.low = 0.0, .high = 10.0};
  const EquationText text_;
  bool has_own_j_;
  FileFormulas formulas_;
  std::vector<UnknownText> rows_{};
  int last_number_ = 0;
};

}  // namespace

EquationText with_implied_rows(EquationText text, const Parameters& parameters) {
  const auto has_call = [](const UnknownText& one) { return next_call(one.rhs.text, 0).has_value(); };
  if (text.mechanics || std::ranges::none_of(text.unknowns, has_call)) return text;
  return ImpliedRows(std::move(text), parameters).complete();
}

}  // namespace fde::bench
