// SPDX-License-Identifier: MIT
// fde_fuzz_corpora TARGET FILE...: a fuzz target on every file of its corpus, without a fuzzer; also of
// folders.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "fuzz/fuzzing.hpp"

namespace {

using namespace fde::bench::fuzz;
using Target = int (*)(const std::uint8_t* data, std::size_t size);
const std::map<std::string_view, Target> targets{{"command_line", command_line},
                                                 {"equation_file", equation_file},
                                                 {"mittag_leffler", mittag_leffler},
                                                 {"parameter_values", parameter_values},
                                                 {"prabhakar", prabhakar},
                                                 {"records", records},
                                                 {"reference_files", reference_files}};

void run(Target target, const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string bytes = text.str();
  fmt::print(stderr, "{}\n", file.string());
  target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) {
  const auto target = count > 1 ? targets.find(arguments[1]) : targets.end();
  if (target == targets.end()) return 2;
  std::vector<std::filesystem::path> files;
  for (int i = 2; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i])) {
      files.emplace_back(arguments[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(arguments[i])) files.push_back(entry.path());
  }
  for (auto& file : files) file = std::filesystem::absolute(file);  // a target may change the folder
  std::ranges::sort(files);
  for (const auto& file : files) run(target->second, file);
  fmt::print("{} inputs\n", files.size());
  return files.empty() ? 1 : 0;
}
