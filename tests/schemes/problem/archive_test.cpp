// SPDX-License-Identifier: MIT
// An archive restores what was written, to the bit, and rejects everything else.

#include "fdebench/schemes/problem/archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace fde::bench {
namespace {

std::string written(const fde::StateArchiver& state) {
  std::string bytes;
  WritingArchive archive([&](std::string_view more) { bytes += more; });
  state(archive);
  return bytes;
}

void read(const std::string& bytes, const fde::StateArchiver& state) {
  std::size_t next = 0;
  ReadingArchive archive([&](char* to, std::size_t count) { next += bytes.copy(to, count, next); },
                         bytes.size());
  state(archive);
  archive.end();
}

struct Part {
  int count = 0;
  bool flag = false;
  double value = 0.0;
  void state(Archive& archive) { archive(count, flag, value); }
};

TEST(Archive, GivesBackNumbersToTheBit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Vec values(4), again = Vec::Zero(4);
  values << -0.0, nan, 5e-324, 1.0 / 3.0;
  read(written([&](Archive& archive) { archive(values); }), [&](Archive& archive) { archive(again); });
  EXPECT_TRUE(std::signbit(again[0]));
  EXPECT_TRUE(std::isnan(again[1]));
  EXPECT_EQ(again.tail(2), values.tail(2));
}

TEST(Archive, GivesBackParts) {
  Part part{7, true, 0.5}, same;
  std::optional<double> some = 2.0, none, was_none, was_some = 3.0;
  std::vector<Part> parts(2, part), other(2);
  std::vector<bool> sides{true, false, true}, sides_again(3);
  const auto bytes = written([&](Archive& archive) { archive(part, some, none, parts, sides); });
  read(bytes, [&](Archive& archive) { archive(same, was_none, was_some, other, sides_again); });
  EXPECT_EQ(same.count, 7);
  EXPECT_TRUE(same.flag);
  EXPECT_EQ(was_none, 2.0);
  EXPECT_EQ(was_some, std::nullopt);
  EXPECT_EQ(other[1].value, 0.5);
  EXPECT_EQ(sides_again, sides);
}

TEST(Archive, GivesBackWhatHasGrown) {
  std::vector<double> times{1.0, 2.0, 3.0}, no_times;
  Matrix path = Matrix::Random(2, 8), no_path = Matrix::Zero(2, 1), whole = Matrix::Random(3, 2), empty;
  SparseMatrix few(3, 3), none(3, 3);
  few.insert(0, 2) = 4.0;
  few.insert(1, 1) = 5.0;
  read(written([&](Archive& archive) {
         archive.resizable(times);
         archive.first_columns(path, 3);
         archive.resizable(whole);
         archive.resizable(few);
       }),
       [&](Archive& archive) {
         archive.resizable(no_times);
         archive.first_columns(no_path, 3);
         archive.resizable(empty);
         archive.resizable(none);
       });
  EXPECT_EQ(no_times, times);
  EXPECT_EQ(no_path, path.leftCols(3));
  EXPECT_EQ(empty, whole);
  EXPECT_EQ(Matrix(none), Matrix(few));
}

TEST(Archive, TakesNoOtherSizeAndNoNumberOutOfItsRange) {
  Vec three = Vec::Ones(3), four = Vec::Ones(4);
  const auto bytes = written([&](Archive& archive) { archive(three); });
  EXPECT_THROW(read(bytes, [&](Archive& archive) { archive(four); }), std::invalid_argument);
  int count = 5;
  const auto five = written([&](Archive& archive) { archive.count(count, 0, 5); });
  EXPECT_THROW(read(five, [&](Archive& archive) { archive.count(count, 0, 4); }), std::invalid_argument);
  EXPECT_THROW(read(five, [&](Archive& archive) { archive.count(count, 6, 9); }), std::invalid_argument);
}

// 2^60 numbers do not fit into any memory: the size is rejected before any allocation.
TEST(Archive, AllocatesNoMoreThanIsLeft) {
  std::int64_t size = std::int64_t{1} << 60;
  const auto bytes = written([&](Archive& archive) { archive(size); });
  std::vector<double> values;
  Vec vector;
  EXPECT_THROW(read(bytes, [&](Archive& archive) { archive.resizable(values); }), std::invalid_argument);
  EXPECT_THROW(read(bytes, [&](Archive& archive) { archive.resizable(vector); }), std::invalid_argument);
  size = -1;
  const auto negative = written([&](Archive& archive) { archive(size); });
  EXPECT_THROW(read(negative, [&](Archive& archive) { archive.resizable(values); }), std::invalid_argument);
}

TEST(Archive, TakesNoMatrixWhoseEntriesAreOutside) {
  SparseMatrix few(3, 3), none(3, 3);
  few.insert(2, 2) = 4.0;
  auto bytes = written([&](Archive& archive) { archive.resizable(few); });
  few.innerIndexPtr()[0] = 3;
  const auto outside = written([&](Archive& archive) {
    // The bytes that the writer would write if it did not check the entries too.
    std::int64_t three = 3, four = 4, one = 1;
    std::vector<int> outer{0, 0, 0, 1}, inner{3};
    double value = 4.0;
    archive(three, three, four);
    for (int& entry : outer) archive(entry);
    archive(one, inner[0], value);
  });
  ASSERT_EQ(outside.size(), bytes.size());
  EXPECT_THROW(read(outside, [&](Archive& archive) { archive.resizable(none); }), std::invalid_argument);
}

TEST(Archive, EndsWhereItWasWritten) {
  double one = 1.0, two = 2.0;
  const auto bytes = written([&](Archive& archive) { archive(one); });
  EXPECT_THROW(read(bytes, [&](Archive& archive) { archive(one, two); }), std::invalid_argument);
  EXPECT_THROW(read(bytes + "x", [&](Archive& archive) { archive(one); }), std::invalid_argument);
}

}  // namespace
}  // namespace fde::bench
