#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace fde {

// A file that appears whole, in place of one that is there, whose permissions it takes, or not at all: it is
// written under another name, of this process and object alone, and renamed at the end. A symbolic link stays
// and its target is replaced. What processes that were killed while they wrote the same file have left beside
// it is removed first. A pipe or a device, which nothing can replace, is written to at once. Throws
// std::invalid_argument naming the path and why it cannot be written.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path& path);
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  ~WholeFile();  // what is not finished is removed

  void write(std::string_view text);
  void finish();
  void finish_new();  // throws as well where the path exists by now: of several at once one succeeds

 private:
  void check() const;
  [[nodiscard]] bool in_place() const { return unfinished_ == path_; }

  std::filesystem::path path_, unfinished_;
  std::ofstream stream_;
};

}  // namespace fde
