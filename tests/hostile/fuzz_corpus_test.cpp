// A scene or scheme that is added, or renamed, has its seeds for the fuzzer.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "scenes/registry.hpp"
#include "support/testing.hpp"

namespace fde {
namespace {

// What stands in that line of the files of tests/fuzz/corpus/parameter_values.
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

TEST(FuzzCorpus, HasSeedsOfEveryScene) {
  const auto seeds = texts_of_line(0);
  for (const auto& maker : scenes()) EXPECT_TRUE(seeds.contains(std::string(maker.id))) << maker.id;
}

TEST(FuzzCorpus, HasSeedsOfEveryScheme) {
  const auto seeds = texts_of_line(1);
  for (const auto& scheme : schemes()) EXPECT_TRUE(seeds.contains(std::string(scheme.id))) << scheme.id;
}

}  // namespace
}  // namespace fde
