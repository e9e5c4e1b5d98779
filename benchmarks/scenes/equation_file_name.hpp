#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fde {

// Extension of an equation file.
inline constexpr std::string_view equation_file_ending = ".toml";

// "FILE.toml" from "FILE.toml" or "FILE.toml:NAME=VALUE,..."; nullopt: the text names no equation file.
inline std::optional<std::string> equation_file_in(const std::string& text) {
  const auto end = text.find(std::string(equation_file_ending) + ':');
  if (end != std::string::npos) return text.substr(0, end + equation_file_ending.size());
  return text.ends_with(equation_file_ending) ? std::optional(text) : std::nullopt;
}

}  // namespace fde
