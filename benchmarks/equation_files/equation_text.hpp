// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/schemes/stepping/events.hpp"

namespace fde::bench {

// A position in a file: line and column, from 1.
struct TextPosition {
  int line = 1, column = 1;
};

// A formula as written in an equation file, or a number as its shortest decimal.
struct FormulaText {
  std::string text{};
  TextPosition position{};             // of its first byte, or of the enclosing string
  bool maps_bytes_to_columns = false;  // whether byte b of the text is at column position.column + b
};

struct TermText {
  FormulaText coefficient, order;
};

// The equation of an unknown: sum of the terms = rhs.
struct UnknownText {
  std::string name{};
  TextPosition position{};
  std::vector<TermText> terms{};
  bool may_be_algebraic = false;  // given by the key `order`, for which 0 means 0 = rhs
  FormulaText rhs{};
  std::vector<FormulaText> initial{};
};

struct NamedFormula {
  std::string name{};
  TextPosition position{};
  FormulaText formula{};
};

struct EnergyText {
  FormulaText value{};
  std::optional<FormulaText> power{};
};

struct ParameterText {
  std::string name{};
  double value = 0.0;
};

// [event.NAME]: a function whose zeros along the trajectory are located.
struct EventText {
  std::string name{};
  FormulaText zero{};
  Crossing crossing = Crossing::either;
  bool terminal = false;
};

// The contents of an equation file with unparsed formulas: docs/equation_files.md.
struct EquationText {
  std::string file{};
  std::string title{};
  FormulaText end{};
  std::vector<ParameterText> parameters{};  // parameters and unknowns are in file order
  std::vector<UnknownText> unknowns{};
  std::vector<NamedFormula> exact{};
  std::optional<EnergyText> energy{};
  std::vector<FormulaText> constraints{};
  std::vector<FormulaText> jumps{};
  std::vector<EventText> events{};
  std::string checksum{};  // SHA-256 of all fields except the title
};

inline constexpr std::size_t max_equation_file_bytes = std::size_t{1} << 20;  // bytes
inline constexpr std::size_t max_unknowns = 100;

// Each throws std::invalid_argument naming file, line and column, the text there and what is allowed.
EquationText read_equation_text(const std::filesystem::path& file);
EquationText parse_equation_text(const std::string& file, std::string_view text);

// "FILE: line L, column C: what"
[[noreturn]] void reject_at(const std::string& file, const TextPosition& place, std::string_view what);
// The same for a byte of a formula.
[[noreturn]] void reject_in(const std::string& file, const FormulaText& formula, std::size_t byte,
                            std::string_view what);

}  // namespace fde::bench
