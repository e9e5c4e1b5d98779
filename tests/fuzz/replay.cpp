// SPDX-License-Identifier: MIT
// Runs a fuzz target on every file of its corpus, without a fuzzer: the arguments are files and folders.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "fuzz/fuzzing.hpp"

namespace {

void run(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string bytes = text.str();
  fmt::print(stderr, "{}\n", file.string());
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i])) {
      files.emplace_back(arguments[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(arguments[i])) files.push_back(entry.path());
  }
  for (auto& file : files) file = std::filesystem::absolute(file);  // a target may change the folder
  std::ranges::sort(files);
  std::ranges::for_each(files, run);
  fmt::print("{} inputs\n", files.size());
  return files.empty() ? 1 : 0;
}
