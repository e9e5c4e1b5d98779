// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/equation_files/line_pieces.hpp"
#include "fdebench/benchmarks/expressions/foreign_notation.hpp"
#include "fdebench/benchmarks/text/entry_named.hpp"

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

// The position of a TOML key, such as a.b.c, with more than max_key_parts parts, outside strings and
// comments; nullopt if there is none. Parts are nested tables: a recursive parser would exhaust the stack.
constexpr int max_key_parts = 16;
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

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

// What a formula in a wrong place needs.
std::string_view hint_of_toml(std::string_view fault) {
  const auto has = [=](std::string_view words) { return fault.find(words) != std::string_view::npos; };
  if (has("unescaped control characters"))
    return R"(; a formula of several lines stands between """ and """)";
  if (has("floating-point: expected")) return "; a number has a digit before its point, as 0.5";
  return has("value type") || has("decimal integer") ? "; a formula stands in quotes" : "";
}

}  // namespace

TextPosition position_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

TextPosition position_of(const toml::node& node) { return position_of(node.source()); }

toml::table parse_toml(const std::string& file, std::string_view text) {
  if (const auto deep = find_deep_key(text))
    reject_at(file, *deep, fmt::format("a key of more than {} parts", max_key_parts));
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& fault) {
    reject_at(file, position_of(fault.source()),
              fmt::format("no TOML: {}{}", fault.description(), hint_of_toml(fault.description())));
  }
}

TomlReader::TomlReader(const std::string& file, std::string_view text) : file_(file), text_(text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') lines_.push_back(i + 1);
}

void TomlReader::reject(const TextPosition& place, std::string_view what) const {
  reject_at(file_, place, what);
}

void TomlReader::reject_kind(const toml::node& node, std::string_view name, std::string_view allowed) const {
  reject(position_of(node), fmt::format("{}: is {}, must be {}", name, kind_of(node), allowed));
}

const toml::table& TomlReader::table(const toml::node& node, std::string_view name) const {
  if (const auto* found = node.as_table()) return *found;
  reject_kind(node, name, "a table");
}

const toml::array& TomlReader::array(const toml::node& node, std::string_view name,
                                     std::string_view allowed) const {
  if (const auto* found = node.as_array()) return *found;
  reject_kind(node, name, allowed);
}

std::vector<TomlEntry> TomlReader::entries(const toml::node& node, std::string_view name) const {
  std::vector<TomlEntry> found;
  for (const auto& [key, value] : table(node, name))
    found.push_back({std::string(key.str()), position_of(key.source()), &value});
  std::ranges::stable_sort(found, {}, [](const TomlEntry& entry) {
    return std::pair(entry.position.line, entry.position.column);
  });
  return found;
}

void TomlReader::require_keys(const toml::table& of, std::string_view name,
                              const std::vector<std::string_view>& allowed) const {
  for (const auto& entry : entries(of, name)) {
    if (std::ranges::find(allowed, entry.name) != allowed.end()) continue;
    auto hint = key_hint(entry.name);
    if (hint.empty()) hint = did_you_mean(entry.name, allowed);
    if (hint.empty() && name == "the file" && entry.node->is_number())
      hint = "; a parameter stands under [parameters]";
    reject(entry.position, fmt::format("{}: no such key of {}{}; there are {}", entry.name, name, hint,
                                       fmt::join(allowed, ", ")));
  }
}

const toml::node& TomlReader::required(const toml::table& of, const TextPosition& place,
                                       std::string_view name, std::string_view key) const {
  if (const auto* found = of.get(key)) return *found;
  reject(place, fmt::format("{}: has no {}, which it must have", name, key));
}

FormulaText TomlReader::formula(const toml::node& node, std::string_view name) const {
  FormulaText made{.position = position_of(node)};
  if (const auto* text = node.as_string()) {
    made.text = text->get();
    const auto line = lines_[static_cast<std::size_t>(made.position.line) - 1];
    made.pieces = line_pieces(text_.substr(line), made.position, made.text);
    if (!made.pieces.empty()) made.position = made.pieces.front().position;
  } else if (const auto* whole = node.as_integer()) {
    made.text = std::to_string(whole->get());
  } else if (const auto* number = node.as_floating_point()) {
    if (!std::isfinite(number->get()))
      reject(made.position, fmt::format("{} = {}: must be a finite number", name, number->get()));
    made.text = fmt::format("{}", number->get());
  } else {
    reject_kind(node, name, "a number or a formula");
  }
  return made;
}

std::vector<FormulaText> TomlReader::formulas(const toml::node& node, std::string_view name,
                                              std::string_view allowed) const {
  std::vector<FormulaText> all;
  for (const auto& value : array(node, name, allowed)) all.push_back(formula(value, name));
  return all;
}

}  // namespace fde::bench
