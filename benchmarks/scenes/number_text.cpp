#include "scenes/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace fde {
namespace {

template <typename Number>
std::optional<Number> read(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

void reject_text(std::string_view name, std::string_view text, std::string_view allowed) {
  throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, text, allowed));
}

std::optional<double> number_in(std::string_view text) { return read<double>(text); }

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  for (const auto& part : split_list(text)) {
    const auto number = number_in(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

double parse_number(std::string_view name, std::string_view text, const Range& allowed) {
  const auto value = number_in(text);
  if (!value) reject_text(name, text, allowed.text());
  if (!allowed.contains(*value)) reject_text(name, fmt::format("{}", *value), allowed.text());
  return *value;
}

int parse_count(std::string_view name, std::string_view text, int lowest, int highest) {
  const auto value = read<int>(text);
  if (!value || *value < lowest || *value > highest) {
    reject_text(name, text, fmt::format("a whole number from {} to {}", lowest, highest));
  }
  return *value;
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed) {
  std::vector<double> numbers;
  for (const auto& part : split_list(text)) numbers.push_back(parse_number(name, part, allowed));
  return numbers;
}

}  // namespace fde
