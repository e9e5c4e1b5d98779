// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/output_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fde::bench {
namespace {

double power_of_ten_in(double value) { return std::floor(std::log10(value)); }

}  // namespace

std::string error_text(double error) {
  if (error == 0.0) return "0";
  const std::string text = fmt::format("{:.1e}", error);  // with an exponent like e-07 or e+02
  const auto exponent = text.find('e');
  return fmt::format("{}e{}", text.substr(0, exponent), std::stoi(text.substr(exponent + 1)));
}

// In the largest unit in which the number is at least 1, otherwise in the last unit.
std::string time_text(double seconds) {
  struct Unit {
    double size;
    const char* name;
  };
  static constexpr std::array units{Unit{1.0, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "µs"}, Unit{1e-9, "ns"}};
  const auto* const found =
      std::ranges::find_if(units, [&](const Unit& unit) { return seconds >= unit.size; });
  const Unit& unit = found == units.end() ? units.back() : *found;
  const double number = seconds / unit.size;
  const int decimals = number < 1.0 ? 2 : std::max(0, 2 - static_cast<int>(power_of_ten_in(number)));
  return fmt::format("{:.{}f} {}", number, decimals, unit.name);
}

std::string_view clock_note(bool wall_clock) { return wall_clock ? " of the wall clock" : ""; }

std::string count_text(double count) {
  if (count >= 1e9) return error_text(count);
  std::string digits = fmt::format("{:.0f}", count);
  if (count < 1e4) return digits;
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), "\u202f");
  }
  return digits;
}

std::string rough_count_text(double count) {
  if (count < 100.0) return count_text(count);
  const double unit = std::pow(10.0, power_of_ten_in(count) - 1.0);
  return count_text(std::round(count / unit) * unit);
}

std::string replaced(std::string_view text, const std::map<char, std::string_view>& replacements) {
  std::string result;
  for (const char c : text) {
    const auto found = replacements.find(c);
    result += found == replacements.end() ? std::string_view(&c, 1) : found->second;
  }
  return result;
}

// A letter like µ has two bytes.
std::string aligned(const std::vector<TableRow>& rows, std::size_t gap) {
  const auto width_of = [](std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
  };
  std::vector<std::size_t> widths;
  for (const TableRow& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const TableRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widths[i] - width_of(row[i]) + gap, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace fde::bench
