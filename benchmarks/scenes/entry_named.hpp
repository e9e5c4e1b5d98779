#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fde {

// ", did you mean 'x'?" with the candidate of least edit distance to the name.
std::string nearest(std::string_view name, const std::vector<std::string_view>& candidates);

// Throws std::invalid_argument: "KIND ID: no such KIND, did you mean 'X'?; there are ...", where there are
// many the nearest ones only.
[[noreturn]] void no_such(std::string_view kind, std::string_view id,
                          const std::vector<std::string_view>& ids);

// The entry of this id. Throws std::invalid_argument naming the kind, the id and the ids that there are.
template <typename Entries>
const auto& entry_named(const Entries& entries, std::string_view kind, std::string_view id) {
  std::vector<std::string_view> ids;
  for (const auto& entry : entries) {
    if (entry.id == id) return entry;
    ids.push_back(entry.id);
  }
  no_such(kind, id, ids);
}

}  // namespace fde
