// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {

// Checks of the fields of a results file. Each throws std::invalid_argument naming the field and what is
// allowed.

// A text that can be printed; a name, which is 1 to `most` bytes of such a text.
void require_printable(std::string_view field, std::string_view text);
void require_name(std::string_view field, std::string_view text, std::size_t most = 100);

// Finite times of at least 0 that increase; a list with as many elements as there are times.
void require_times(std::string_view field, const std::vector<double>& times);
void require_length(std::string_view field, std::size_t length, std::size_t times);

// The key of a scene that need not exist: its name, for a scene of an equation file the SHA-256 of its
// contents, and names with finite numbers or printable words.
void require_scene(const SceneSettings& scene);

}  // namespace fde::bench
