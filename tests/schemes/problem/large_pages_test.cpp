// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/large_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

namespace fde::bench {
namespace {

// The flags of the mapping that contains an address (proc_pid_smaps(5)); empty: not known.
std::string flags_at(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  bool found = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream range(line);
    std::uintptr_t begin = 0, end = 0;
    char dash = ' ';
    if (range >> std::hex >> begin >> dash >> end && dash == '-') found = begin <= wanted && wanted < end;
    if (found && line.starts_with("VmFlags:")) return line + ' ';
  }
  return {};
}

TEST(LargePages, AreWantedForLargeMatricesOnly) {
  Matrix matrix;
  allocate(matrix, 1 << 20, 8);
  ASSERT_EQ(matrix.rows(), 1 << 20);
  ASSERT_EQ(matrix.cols(), 8);
  const std::string flags = flags_at(&matrix(1 << 19, 4));
  if (flags.empty()) GTEST_SKIP() << "the system does not tell";
  EXPECT_NE(flags.find(" hg "), std::string::npos) << flags;
  Matrix small;
  allocate(small, 300, 8);
  EXPECT_EQ(small.size(), 2400);
  EXPECT_EQ(flags_at(small.data()).find(" hg "), std::string::npos);
}

}  // namespace
}  // namespace fde::bench
