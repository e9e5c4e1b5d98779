#pragma once

#include <optional>
#include <string_view>

#include "equation_files/equation_text.hpp"

namespace fde {

// Where a key of TOML, such as a.b.c, has more parts than this, outside strings and comments. Each part is a
// table in another, and a reader that goes down them by recursion would not come back.
inline constexpr int most_key_parts = 16;
std::optional<TextPlace> deep_key(std::string_view toml);

}  // namespace fde
