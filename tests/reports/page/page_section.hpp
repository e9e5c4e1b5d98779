// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fde::bench {

// The text of a cell: the cell is a string, or an object whose text defaults to the label of its line.
inline std::string to_text(const nlohmann::json& cell) {
  if (cell.is_string()) return cell;
  return cell.contains("text") ? cell["text"] : cell["line"];
}

// The section of a page's data with this id; null if there is none.
inline nlohmann::json section(const nlohmann::json& page, const std::string& id) {
  for (const auto& one : page["sections"]) {
    if (one["id"] == id) return one;
  }
  return {};
}

}  // namespace fde::bench
