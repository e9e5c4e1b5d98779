// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"

namespace fde::bench {

// The table [mechanics] of a file with these coordinates; file and text as in TomlReader. Throws
// std::invalid_argument naming file, line and column, the value and what is allowed.
MechanicsText read_mechanics(const std::string& file, std::string_view text, const toml::node& node,
                             const std::vector<UnknownText>& coordinates);

}  // namespace fde::bench
