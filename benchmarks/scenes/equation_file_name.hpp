// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fde::bench {

// Extension of an equation file.
inline constexpr std::string_view equation_file_extension = ".toml";

// "FILE.toml" from "FILE.toml" or "FILE.toml:NAME=VALUE,..."; nullopt: the text names no equation file.
inline std::optional<std::string> equation_file_of_label(const std::string& text) {
  const auto end = text.find(std::string(equation_file_extension) + ':');
  if (end != std::string::npos) return text.substr(0, end + equation_file_extension.size());
  return text.ends_with(equation_file_extension) ? std::optional(text) : std::nullopt;
}

}  // namespace fde::bench
