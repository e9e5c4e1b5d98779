// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// A run or a description of a scene is valid if it is well formed: names can be printed, numbers are finite
// and in the range of their field. This build need not have the scene, the scheme, the measures or the
// ending; of a measure that it has, the range of the value is checked. Each throws std::invalid_argument
// naming what is invalid and what is allowed.
void require_valid(const Record& run);
void require_valid(const LaterTimes& times);
void require_valid(const SceneDescription& scene);
inline void require_valid(const Session& /*session*/) {}

// Throws std::invalid_argument naming the argument if the text is not a valid name of another program: an id
// of our schemes, empty, longer than 100 bytes, not UTF-8, or not printable.
void require_external_name(std::string_view name, std::string_view text);

// The unit of a measure; empty for one without a unit or of another build.
std::string_view unit_of(std::string_view quantity);

// Whether this build has a measure with this id.
bool is_measure(std::string_view quantity);

}  // namespace fde::bench
