// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {

namespace fs = std::filesystem;

// A folder in which a file cannot be written.
class Unwritable : public testing::Test {
 protected:
  void SetUp() override { fs::permissions(folder_.path(), fs::perms::all); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      found.push_back(entry.path().lexically_relative(folder_.path()).string());
    std::ranges::sort(found);
    return found;
  }
  static CommandOutput run_into(const fs::path& file) {
    return fdebench({"run", "--scene", "power", "--scheme", "l1", "--steps", "8", "--repeat", "1", "--out",
                     file.string()});
  }
  const TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "results.jsonl";
};

}  // namespace fde::bench
