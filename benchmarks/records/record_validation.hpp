// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// A row of results or a description of a scene is valid if it is well formed: names can be printed, numbers
// are finite and in the range of their field. This build need not have the scene, the scheme, the quantity or
// the ending; of a quantity that it has, the unit and the range of the value are checked. Each throws
// std::invalid_argument naming what is invalid and what is allowed.
void require_valid(const Record& row);
void require_valid(const SceneDescription& scene);

// Throws std::invalid_argument naming the argument if the text is not a valid name of another program: an id
// of our schemes, empty, longer than 100 bytes, not UTF-8, or not printable.
void require_external_name(std::string_view name, std::string_view text);

}  // namespace fde::bench
