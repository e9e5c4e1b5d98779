// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "fdebench/reports/command/help_text.hpp"

namespace fde::bench {
namespace {

// The words of a paragraph in indented lines.
std::string filled(std::string_view paragraph, std::size_t columns, std::size_t indent) {
  std::istringstream words{std::string(paragraph)};
  std::string text, line, word;
  while (words >> word) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > columns) {
      text += fmt::format("{:{}}{}\n", "", indent, line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? text : text + fmt::format("{:{}}{}\n", "", indent, line);
}

// A row of a table with the description aligned where it takes several lines; another line as it is.
std::string filled_row(std::string_view line, std::size_t columns, std::size_t indent) {
  const auto begin = description_of_row(line);
  if (begin == std::string_view::npos || indent + line.size() <= columns)
    return fmt::format("{:{}}{}\n", "", indent, line);
  const auto description = filled(line.substr(begin), columns, indent + begin);
  return fmt::format("{:{}}{}{}", "", indent, line.substr(0, begin), description.substr(indent + begin));
}

}  // namespace

std::size_t description_of_row(std::string_view line) {
  const auto gap = line.find("  ", std::min(line.find_first_not_of(' '), line.size()));
  return gap == std::string_view::npos ? gap : line.find_first_not_of(' ', gap);
}

std::string in_colour(std::string_view text, Colour colour, bool shown) {
  constexpr std::array codes{"1", "1;31", "1;33", "1;32"};
  if (!shown) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", codes.at(static_cast<std::size_t>(colour)), text);
}

std::string wrapped(std::string_view text, int columns, int indent) {
  const auto width = static_cast<std::size_t>(columns), margin = static_cast<std::size_t>(indent);
  std::istringstream lines{std::string(text)};
  std::string result, paragraph, line;
  const auto end_paragraph = [&] {
    result += filled(paragraph, width, margin);
    paragraph.clear();
  };
  while (std::getline(lines, line)) {
    if (!line.empty() && line.front() != ' ') {
      paragraph += line + ' ';
      continue;
    }
    end_paragraph();
    result += line.empty() ? "\n" : filled_row(line, width, margin);
  }
  end_paragraph();
  return result;
}

std::string wrapped_item(std::string_view name, std::string_view description, int width, int columns,
                         bool bold) {
  constexpr int gap = 2;
  const int indent = gap + width + gap;
  std::string text = wrapped(description, columns, indent);
  const auto shown = in_colour(name, Colour::bold, bold);
  if (static_cast<int>(name.size()) > width || text.empty()) return fmt::format("  {}\n{}", shown, text);
  return fmt::format("  {}{:{}}{}", shown, "", indent - gap - static_cast<int>(name.size()),
                     text.substr(static_cast<std::size_t>(indent)));
}

}  // namespace fde::bench
