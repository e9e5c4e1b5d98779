// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fde::bench {

// ", did you mean 'x'?" with the candidate at the least edit distance from `name`; empty if none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates);

// Throws std::invalid_argument: "KIND ID: no such KIND, did you mean 'X'?; there are ...". More than ten ids
// are not all listed: only the three nearest.
[[noreturn]] void throw_unknown_id(std::string_view kind, std::string_view id,
                                   const std::vector<std::string_view>& ids);

// The entry with this id. Throws std::invalid_argument naming the kind, the id and the existing ids.
template <typename Entries>
const auto& entry_by_id(const Entries& entries, std::string_view kind, std::string_view id) {
  std::vector<std::string_view> ids;
  for (const auto& entry : entries) {
    if (entry.id == id) return entry;
    ids.push_back(entry.id);
  }
  throw_unknown_id(kind, id, ids);
}

}  // namespace fde::bench
