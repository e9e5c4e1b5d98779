// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/equation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace fde::bench {
namespace {

bool is_left_out(const ParameterValues& unless, const Parameters& parameters) {
  const auto holds = [&](const auto& condition) {
    return parameters.value(condition.first) == condition.second;
  };
  return !unless.empty() && std::ranges::all_of(unless, holds);
}

}  // namespace

EquationText present_parts(EquationText text, const Parameters& parameters) {
  const auto left_out = [&](const auto& part) { return is_left_out(part.unless, parameters); };
  for (const auto& unknown : text.unknowns)
    if (left_out(unknown)) text.absent_unknowns.push_back(unknown.name);
  std::erase_if(text.unknowns, left_out);
  std::erase_if(text.columns, left_out);
  std::erase_if(text.requirements, left_out);
  return text;
}

void reject_at(const std::string& file, const TextPosition& place, std::string_view what) {
  constexpr std::size_t longest = 600;
  std::size_t shown = std::min(what.size(), longest);
  while (shown < what.size() && shown > 0 && (static_cast<unsigned char>(what[shown]) & 0xc0U) == 0x80U)
    --shown;  // do not split a UTF-8 character
  std::string line(what.substr(0, shown));
  if (shown < what.size()) line += " ...";
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  throw FileError(fmt::format("{}: line {}, column {}: {}", file, place.line, place.column, line));
}

void reject_in(const std::string& file, const FormulaText& formula, std::size_t byte, std::string_view what) {
  LinePiece piece{0, formula.position};
  for (const auto& one : formula.pieces)
    if (one.first <= byte) piece = one;
  piece.position.column += static_cast<int>(byte - piece.first);
  reject_at(file, piece.position, what);
}

std::string read_text_file(const std::filesystem::path& file, std::size_t most_bytes) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{}: cannot be read: {}", file.string(), why));
  };
  std::error_code problem;
  const auto kind = std::filesystem::status(file, problem);
  if (!std::filesystem::exists(kind)) refuse("there is no such file");
  if (!std::filesystem::is_regular_file(kind)) refuse("it is no file");
  const auto size = std::filesystem::file_size(file, problem);
  if (problem) refuse(problem.message());
  if (size > most_bytes) refuse(fmt::format("it has {} bytes: must be at most {}", size, most_bytes));
  std::string text(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(std::strerror(errno));
  stream.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

EquationText read_equation_text(const std::filesystem::path& file) {
  return parse_equation_text(file.string(), read_text_file(file, max_equation_file_bytes));
}

}  // namespace fde::bench
