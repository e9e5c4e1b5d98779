// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/deep_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace fde::bench {
namespace {

// Index after the string that begins at `begin`, in one quote or three; the end of the line if a single quote
// is not closed.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool is_long = text.substr(begin, 3) == std::string(3, quote);
  const std::size_t quotes = is_long ? 3 : 1;
  for (auto i = begin + quotes; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (!is_long && text[i] == '\n') {
      return i;
    } else if (text[i] == quote && (!is_long || text.substr(i, 3) == text.substr(begin, 3))) {
      return i + quotes;
    }
  }
  return text.size();
}

TextPosition position_of(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, byte);
  const auto line = before.rfind('\n');
  const auto begin = line == std::string_view::npos ? 0 : line + 1;
  return {1 + static_cast<int>(std::ranges::count(before, '\n')), 1 + static_cast<int>(byte - begin)};
}

}  // namespace

std::optional<TextPosition> find_deep_key(std::string_view toml) {
  constexpr std::string_view separators = "=,\n[]{}";
  int points = 0;
  for (std::size_t i = 0; i < toml.size();) {
    const char c = toml[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(toml, i);
      continue;
    }
    if (c == '#') {
      i = std::min(toml.find('\n', i), toml.size());
      continue;
    }
    if (separators.find(c) != std::string_view::npos) points = 0;
    if (c == '.' && ++points >= max_key_parts) return position_of(toml, i);
    ++i;
  }
  return std::nullopt;
}

}  // namespace fde::bench
