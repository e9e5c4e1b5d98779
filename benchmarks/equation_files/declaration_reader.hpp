// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/equation_files/toml_text.hpp"

namespace fde::bench {

// Reads what a file declares about its parameters and its output. Each function throws std::invalid_argument
// naming file, line and column, the text there and what is allowed.
class DeclarationReader : protected TomlReader {
 public:
  using TomlReader::TomlReader;

 protected:
  // A text of at most 200 bytes that prints.
  [[nodiscard]] std::string printable_text(const toml::node& node, std::string_view name) const;
  // Throws unless the name can be used in formulas.
  void require_name(const TomlEntry& entry, std::string_view kind) const;

  [[nodiscard]] std::vector<ParameterText> parameters_of(const toml::node& node) const;
  [[nodiscard]] std::vector<RequirementText> requirements_of(const toml::node& node,
                                                             const std::vector<ParameterText>& known) const;
  [[nodiscard]] std::vector<ColumnText> columns_of(const toml::node& node,
                                                   const std::vector<ParameterText>& known) const;
  [[nodiscard]] DomainText domain_of(const toml::node& node) const;
  // The condition `unless` of a table; empty if it has none.
  [[nodiscard]] ParameterValues unless_of(const toml::table& of,
                                          const std::vector<ParameterText>& known) const;
  [[nodiscard]] double number_of(const toml::node& node, std::string_view name) const;

 private:
  [[nodiscard]] ParameterText parameter_of(const TomlEntry& entry) const;
  [[nodiscard]] ParameterText described_parameter(const TomlEntry& entry) const;
  [[nodiscard]] std::vector<std::string> choices_of(const toml::node& node) const;
  [[nodiscard]] Range range_of(const toml::table& of) const;
  [[nodiscard]] RequirementText requirement_of(const toml::node& node,
                                               const std::vector<ParameterText>& known) const;
  [[nodiscard]] const Parameter& known_parameter(const TomlEntry& entry,
                                                 const std::vector<ParameterText>& known) const;
};

// The names of the columns that a command adds.
bool is_added_column(std::string_view name);

}  // namespace fde::bench
