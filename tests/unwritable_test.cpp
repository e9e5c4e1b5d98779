// Full disks, read-only and vanished folders: one line naming the path, nothing half written. As root, which
// may write everywhere, the tests of permissions run as an ordinary user.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "command.hpp"
#include "experiment.hpp"
#include "record.hpp"
#include "reference_cache.hpp"
#include "reference_folder.hpp"
#include "temporary_folder.hpp"
#include "testing.hpp"

namespace fde {
namespace {

namespace fs = std::filesystem;

struct Answer {
  int code;
  std::string err;
};

Answer fdebench(const std::vector<std::string>& arguments) {
  std::ostringstream out, err;
  const int code = run_fdebench(arguments, {.out = out, .err = err});
  return {code, err.str()};
}

Answer run_into(const fs::path& file) {
  return fdebench(
      {"run", "--scene", "power", "--scheme", "l1", "--steps", "8", "--repeat", "1", "--out", file.string()});
}

// A limit on the size of files stands for a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

// Root takes another user for a while.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (geteuid() == 0) changed_ = seteuid(nobody) == 0;
  }
  ~OrdinaryUser() {
    if (changed_ && seteuid(0) != 0) std::abort();
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  static bool is_root() { return geteuid() == 0; }

 private:
  static constexpr uid_t nobody = 65534;
  bool changed_ = false;
};

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
  const TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "results.jsonl";
};

TEST_F(Unwritable, ResultsOnAFullDisk) {
  const FullDisk full(100);
  const auto [code, err] = run_into(file_);
  EXPECT_EQ(code, 2);
  EXPECT_EQ(err, "fdebench: " + file_.string() + ": cannot be written: File too large\n");
  EXPECT_EQ(fs::file_size(file_), 0U);
}

TEST_F(Unwritable, AReportOnAFullDiskLeavesTheOldOne) {
  ASSERT_EQ(run_into(file_).code, 0);
  folder_.write("report/index.html", "old");
  const FullDisk full(1000);
  const auto [code, err] =
      fdebench({"report", file_.string(), "--out", (folder_.path() / "report").string()});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(err,
              testing::MatchesRegex("fdebench: .*/report/index.html.*: cannot be written: File too large\n"));
  EXPECT_THAT(names(), testing::ElementsAre("report", "report/index.html", "results.jsonl"));
  EXPECT_EQ(fs::file_size(folder_.path() / "report" / "index.html"), 3U);
}

TEST_F(Unwritable, ReferenceTablesOnAFullDiskLeaveTheOldOnes) {
  folder_.write("data/a.csv", "old");
  const FullDisk full(1000);
  const fs::path data = folder_.path() / "data";
  EXPECT_THAT(
      [&] {
        replace_folder(data, {{"a.csv", std::string(5000, '1')}});
      },
      testing::ThrowsMessage<std::invalid_argument>(data.string() + ": cannot be written: File too large"));
  EXPECT_THAT(names(), testing::ElementsAre("data", "data/a.csv"));
}

// What is known does not depend on where it can be kept.
TEST_F(Unwritable, ACacheOnAFullDiskKeepsNothingAndHarmsNothing) {
  const Scene scene = scene_of("brusselator");
  Problem problem = scene.problem;
  problem.end = 1.0;
  const auto known = cached_reference("r", problem, ReferenceCache(std::nullopt)).at(1.0);
  const FullDisk full(100);
  const auto found = cached_reference("r", problem, ReferenceCache(folder_.path() / "cache")).at(1.0);
  EXPECT_EQ(found.value, known.value);
  EXPECT_THAT(names(), testing::ElementsAre("cache"));
}

TEST_F(Unwritable, AFullStandardOutput) {
  std::ofstream full("/dev/full");
  if (!full) GTEST_SKIP() << "there is no /dev/full";
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"scenes"},
                                             {"schemes", "--json"},
                                             {"exact", "power", "--at", "1"},
                                             {"mittag-leffler", "1", "1", "1"},
                                             {"solve", "power", "--scheme", "l1", "--steps", "8"}}) {
    full.clear();
    std::ostringstream err;
    EXPECT_EQ(run_fdebench(words, {.out = full, .err = err}), 2) << words[0];
    EXPECT_EQ(err.str(), "fdebench: standard output: cannot be written\n") << words[0];
  }
}

TEST_F(Unwritable, ReadOnlyFolders) {
  ASSERT_EQ(run_into(file_).code, 0);
  fs::permissions(file_, fs::perms::others_read, fs::perm_options::add);
  const fs::path locked = folder_.path() / "locked";
  fs::create_directory(locked);
  fs::permissions(
      locked, fs::perms::all ^ (fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write));
  const OrdinaryUser user;
  if (OrdinaryUser::is_root()) GTEST_SKIP() << "root may write everywhere and cannot be another user here";
  const auto denied = [](const fs::path& path) {
    return "fdebench: " + path.string() + ": cannot be written: Permission denied\n";
  };
  EXPECT_EQ(run_into(locked / "r.jsonl").err, denied(locked / "r.jsonl"));
  EXPECT_EQ(fdebench({"reference", "--out", (locked / "data").string()}).err, denied(locked / "data"));
  EXPECT_EQ(fdebench({"report", file_.string(), "--out", (locked / "report").string()}).err,
            denied(locked / "report"));
  EXPECT_THAT(
      fdebench({"report", file_.string(), "--out", locked.string()}).err,
      testing::MatchesRegex("fdebench: .*/locked/index.html.*: cannot be written: Permission denied\n"));
  EXPECT_TRUE(fs::is_empty(locked));
}

TEST_F(Unwritable, AFolderThatVanishesDuringARun) {
  folder_.write("here/nothing", "");
  const fs::path file = folder_.path() / "here" / "r.jsonl";
  ResultsFile results(file);
  const Record outcome{
      .scene = "power", .scheme = "l1", .history = "auto", .steps = 8, .h = 1.0, .quantity = "outcome"};
  results.append({outcome});
  fs::remove_all(folder_.path() / "here");
  EXPECT_THAT([&] { results.append({outcome}); },
              testing::ThrowsMessage<std::system_error>(file.string() +
                                                        ": cannot be written: No such file or directory"));
}

}  // namespace
}  // namespace fde
