#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fde {

// The text of a cell, which is a text alone or a record whose text may be that of its line.
inline std::string text_of(const nlohmann::json& cell) {
  if (cell.is_string()) return cell;
  return cell.contains("text") ? cell["text"] : cell["line"];
}

// The section of a page's data with this id; null where there is none.
inline nlohmann::json section(const nlohmann::json& page, const std::string& id) {
  for (const auto& one : page["sections"]) {
    if (one["id"] == id) return one;
  }
  return {};
}

}  // namespace fde
