// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The position of a TOML key, such as a.b.c, with more than max_key_parts parts, outside strings and
// comments; nullopt if there is none. Parts are nested tables: a recursive parser would exhaust the stack.
inline constexpr int max_key_parts = 16;
std::optional<TextPosition> find_deep_key(std::string_view toml);

}  // namespace fde::bench
