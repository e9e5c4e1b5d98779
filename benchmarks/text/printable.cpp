// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/printable.hpp"

#include <cstddef>

namespace fde::bench {

bool is_printable(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(i);
    std::size_t more = 0;
    unsigned low = 0x80, high = 0xbf;  // of the second byte
    if (first >= 0xc2 && first <= 0xdf) more = 1;
    if (first >= 0xe0 && first <= 0xef) more = 2;
    if (first >= 0xf0 && first <= 0xf4) more = 3;
    if (more == 0 && (first < ' ' || first >= 0x7f)) return false;
    if (first == 0xc2 || first == 0xe0) low = 0xa0;  // U+0080 to U+009F are control characters
    if (first == 0xed) high = 0x9f;
    if (first == 0xf0) low = 0x90;
    if (first == 0xf4) high = 0x8f;
    for (std::size_t k = 1; k <= more; ++k) {
      if (byte(i + k) < (k == 1 ? low : 0x80) || byte(i + k) > (k == 1 ? high : 0xbf)) return false;
    }
    i += more + 1;
  }
  return true;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> split_names(std::string_view text) {
  std::vector<std::string> names(1);
  int open = 0;
  for (const char c : text) {
    if (c == '(') ++open;
    if (c == ')') --open;
    if (c == ',' && open <= 0) {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name)
    if (c != '(' && c != ')') plain += c == ',' ? '_' : c;
  return plain;
}

std::string shell_word(std::string_view text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789@%+=:,./_-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string csv_names(const std::vector<std::string>& names) {
  std::string line;
  for (const auto& name : names) {
    const std::string quote = name.find(',') == std::string::npos ? "" : "\"";
    if (!line.empty()) line += ',';
    line += quote + name;
    line += quote;
  }
  return line;
}

}  // namespace fde::bench
