// SPDX-License-Identifier: MIT
// Read-only and removed folders: one line naming the path, no partial files. If run by root, who may write
// everywhere, the permission tests switch to an ordinary user.

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "hostile/unwritable_testing.hpp"

namespace fde::bench {
namespace {

// Switches from root to another user during its lifetime.
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
  const Record run{.key = {.scene = {"power"}, .scheme = "l1", .settings = {8}}, .steps = 8};
  results.append(run);
  fs::remove_all(folder_.path() / "here");
  EXPECT_THAT([&] { results.append(run); },
              testing::ThrowsMessage<std::system_error>(file.string() +
                                                        ": cannot be written: No such file or directory"));
}

}  // namespace
}  // namespace fde::bench
