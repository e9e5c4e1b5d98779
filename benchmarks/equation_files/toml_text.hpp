// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// An entry of a table and the position of its key.
struct TomlEntry {
  std::string name;
  TextPosition position;
  const toml::node* node;
};

TextPosition position_of(const toml::source_region& region);
TextPosition position_of(const toml::node& node);

// Throws std::invalid_argument naming file, line and column where the text is no TOML.
toml::table parse_toml(const std::string& file, std::string_view text);

// The contents of a TOML file with positions in its text. A value of another kind than requested throws
// std::invalid_argument naming file, line and column, the value and what is allowed. `file` and `text` must
// outlive this object.
class TomlReader {
 public:
  TomlReader(const std::string& file, std::string_view text);

 protected:
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[noreturn]] void reject(const TextPosition& place, std::string_view what) const;
  [[noreturn]] void reject_kind(const toml::node& node, std::string_view name,
                                std::string_view allowed) const;

  [[nodiscard]] const toml::table& table(const toml::node& node, std::string_view name) const;
  [[nodiscard]] const toml::array& array(const toml::node& node, std::string_view name,
                                         std::string_view allowed) const;
  // The entries of a table in the order of the file.
  [[nodiscard]] std::vector<TomlEntry> entries(const toml::node& node, std::string_view name) const;
  void require_keys(const toml::table& of, std::string_view name,
                    const std::vector<std::string_view>& allowed) const;
  // The value of a key; `place`: position of the table, for the message.
  [[nodiscard]] const toml::node& required(const toml::table& of, const TextPosition& place,
                                           std::string_view name, std::string_view key) const;
  // A formula from a number or a string; the formulas of a list.
  [[nodiscard]] FormulaText formula(const toml::node& node, std::string_view name) const;
  [[nodiscard]] std::vector<FormulaText> formulas(const toml::node& node, std::string_view name,
                                                  std::string_view allowed = "a list of formulas") const;

 private:
  const std::string& file_;
  std::string_view text_;
  std::vector<std::size_t> lines_{0};  // offsets of the lines
};

}  // namespace fde::bench
