// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"

namespace fde::bench {

// Validates rows of results.
class RecordValidator {
 public:
  explicit RecordValidator(const SceneRegistry& known) : known_(known) {}

  // Throws std::invalid_argument naming what is invalid and what is allowed: an unknown scene, setting,
  // scheme or quantity; a unit that is not the unit of the quantity; a value out of the range of the
  // quantity; an invalid setup. The scheme of another program may have any name except the ids of our
  // schemes.
  void require(const Record& row);

 private:
  const SceneRegistry& known_;
  std::optional<SceneSettings> last_{};  // last valid scene; rows of a scene are adjacent
};

// Throws std::invalid_argument naming the argument if the text is not a valid name of another program: an id
// of our schemes, empty, longer than 100 bytes, not UTF-8, or not printable.
void require_external_name(std::string_view name, std::string_view text);

}  // namespace fde::bench
