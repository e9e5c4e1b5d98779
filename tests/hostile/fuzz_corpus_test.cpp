// SPDX-License-Identifier: MIT
// The seeds of the fuzzer must be updated if a scene or scheme is renamed. A new one needs no seed: unknown
// ids are mapped to existing ones.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

// The texts of that line in the files of tests/fuzz/corpus/parameter_values.
std::set<std::string> texts_of_line(int number) {
  std::set<std::string> found;
  for (const auto& file :
       std::filesystem::directory_iterator(FDE_SOURCE_DIR "/tests/fuzz/corpus/parameter_values")) {
    std::ifstream seed(file.path(), std::ios::binary);
    std::string line;
    for (int i = 0; i <= number; ++i) std::getline(seed, line);
    found.insert(line);
  }
  return found;
}

TEST(FuzzCorpus, NamesScenesThatThereAre) {
  for (const auto& id : texts_of_line(0)) EXPECT_NE(find_scene(id), nullptr) << id;
}

TEST(FuzzCorpus, NamesSchemesThatThereAre) {
  for (const auto& id : texts_of_line(1)) EXPECT_NE(find_scheme(id), nullptr) << id;
}

}  // namespace
}  // namespace fde::bench
