// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fde::bench {

// The section of a page's data with this id; null if there is none.
inline nlohmann::json section(const nlohmann::json& page, const std::string& id) {
  for (const auto& one : page["sections"]) {
    if (one["id"] == id) return one;
  }
  return {};
}

}  // namespace fde::bench
