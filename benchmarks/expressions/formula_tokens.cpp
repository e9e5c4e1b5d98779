// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/formula_tokens.hpp"

namespace fde::bench {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

char at(std::string_view text, std::size_t place) { return place < text.size() ? text[place] : '\0'; }

std::size_t skip_digits(std::string_view text, std::size_t place) {
  while (is_digit(at(text, place))) ++place;
  return place;
}

// Index after a decimal that begins at `place`: digits, a point and digits, an exponent.
std::size_t skip_decimal(std::string_view text, std::size_t place) {
  place = skip_digits(text, place);
  if (at(text, place) == '.') place = skip_digits(text, place + 1);
  if (at(text, place) != 'e' && at(text, place) != 'E') return place;
  const bool has_sign = at(text, place + 1) == '+' || at(text, place + 1) == '-';
  const std::size_t exponent = place + (has_sign ? 2 : 1);
  return is_digit(at(text, exponent)) ? skip_digits(text, exponent) : place;
}

}  // namespace

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_in_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

FormulaToken next_token(std::string_view text, std::size_t from) {
  constexpr unsigned kind = 0xc0, continues = 0x80;  // continuation bytes of UTF-8
  while (from < text.size() && is_blank(text[from])) ++from;
  std::size_t end = from;
  if (is_digit(at(text, from)) || (at(text, from) == '.' && is_digit(at(text, from + 1)))) {
    end = skip_decimal(text, from);
  } else if (is_letter(at(text, from))) {
    while (is_in_name(at(text, end))) ++end;
  } else if (from < text.size()) {
    ++end;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & kind) == continues) ++end;
  }
  return {text.substr(from, end - from), from};
}

}  // namespace fde::bench
