// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/files/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <future>
#include <iterator>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(AtomicFile, ReplacesAnotherWhenItIsFinished) {
  const TemporaryFolder folder;
  folder.write("page", "old");
  AtomicFile file(folder.path() / "page");
  file.write("new ");
  file.write("text");
  EXPECT_EQ(content_of(folder.path() / "page"), "old");
  file.commit();
  EXPECT_EQ(content_of(folder.path() / "page"), "new text");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, LeavesNothingWhereItIsNotFinished) {
  const TemporaryFolder folder;
  { AtomicFile(folder.path() / "page").write("half a "); }
  EXPECT_EQ(files_in(folder.path()), 0);
}

// Two writers of the same file at a time.
class WholeFiles : public testing::Test {
 protected:
  WholeFiles() {
    one_.write("one");
    other_.write("other");
  }
  TemporaryFolder folder_;
  AtomicFile one_{folder_.path() / "page"}, other_{folder_.path() / "page"};
};

TEST_F(WholeFiles, OfOneNameAreTheLastThatIsFinished) {
  one_.commit();
  other_.commit();
  EXPECT_EQ(content_of(folder_.path() / "page"), "other");
}

TEST_F(WholeFiles, ThatMustBeNewAreTheFirstThatIsFinished) {
  one_.commit_new();
  EXPECT_THROW(other_.commit_new(), std::invalid_argument);
  EXPECT_EQ(content_of(folder_.path() / "page"), "one");
}

// 2147483647 is not the id of a running process.
TEST(AtomicFile, RemovesWhatAKilledWriterHasLeft) {
  const TemporaryFolder folder;
  folder.write("page.2147483647.0.tmp", "half a ");
  folder.write("page.not.tmp", "another's");
  AtomicFile(folder.path() / "page").commit();
  EXPECT_EQ(files_in(folder.path()), 2);
  EXPECT_EQ(content_of(folder.path() / "page.not.tmp"), "another's");
}

TEST(AtomicFile, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "missing" / "page";
  EXPECT_THAT([&] { AtomicFile{missing}; },
              testing::ThrowsMessage<std::invalid_argument>(
                  missing.string() + ": cannot be written: No such file or directory"));
  EXPECT_THROW(AtomicFile{folder.path()}, std::invalid_argument) << "a folder is not replaced";
}

TEST(AtomicFile, ReplacesTheTargetOfALinkAndTakesItsPermissions) {
  const TemporaryFolder folder;
  const auto target = folder.path() / "target", link = folder.path() / "link";
  folder.write("target", "old");
  const auto mine = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(target, mine);
  fs::create_symlink(target, link);
  AtomicFile file(link);
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content_of(target), "new");
  EXPECT_EQ(fs::status(target).permissions(), mine);
}

// The reader starts before the writer: opening a pipe blocks until the other end is open.
TEST(AtomicFile, IsWrittenIntoAPipe) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
  auto read = std::async(std::launch::async, [&] { return content_of(pipe); });
  {
    AtomicFile file(pipe);
    file.write("text");
    file.commit();
  }
  EXPECT_EQ(read.get(), "text");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace fde::bench
