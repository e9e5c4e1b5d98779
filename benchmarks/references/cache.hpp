#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "nonlinear/panel_table.hpp"

namespace fde {

// References on disk, each under a text that names its problem. A file is CBOR behind its SHA-256; one that
// is damaged, cut short or of another text is not there. Files appear whole, so processes may share a folder.
class ReferenceCache {
 public:
  // No folder: keeps nothing.
  explicit ReferenceCache(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

  // The table stored under the key for this problem, to the last bit.
  [[nodiscard]] std::optional<PanelTable> load(const std::string& key, const Problem& problem) const;

  // A folder that cannot be written, or is in a $HOME that is not there, keeps nothing, silently: the
  // reference is at hand all the same.
  void store(const std::string& key, const PanelTable& table) const;

  // Needs a folder.
  [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;

 private:
  std::optional<std::filesystem::path> folder_;
};

// $FDEBENCH_CACHE (empty: none), else $XDG_CACHE_HOME/fdebench, else $HOME/.cache/fdebench, else none.
std::optional<std::filesystem::path> cache_folder();

// A name with all that decides its reference: the version of the methods, the end, orders and initial values,
// and f at some points, so that an equation that changes in the code has another key.
std::string reference_key(const std::string& name, const Problem& problem);

// The reference of a problem for which no formula is known: two_sided_reference where it is posed at both
// ends, else reference_solution.
Reference computed_reference(const Problem& problem);

// The same, solved once for each key.
Reference cached_reference(const std::string& name, const Problem& problem, const ReferenceCache& cache);

}  // namespace fde
