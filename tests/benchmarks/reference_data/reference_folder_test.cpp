// SPDX-License-Identifier: MIT
// The folder of reference data: written completely or not at all. It passes its own check, which finds
// changes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "benchmarks/reference_data/example_tables.hpp"
#include "fdebench/benchmarks/reference_data/data_table.hpp"
#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

CommandOutput check(const fs::path& folder) { return fdebench({"reference", "--check", folder.string()}); }

void change(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = read_file(file);
  ASSERT_NE(text.find(from), std::string::npos);
  std::ofstream(file, std::ios::binary) << text.replace(text.find(from), from.size(), to);
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

// Two trajectories with 27 times, and two tables with seven numbers of steps for every scheme in
// row_schemes().
std::string recomputed() {
  constexpr std::size_t tables = 2, times = 27, steps = 7;
  return fmt::format("\n4 tables, {} rows recomputed: ", tables * (times + steps * row_schemes().size()));
}

class ReferenceFolderTest : public testing::Test {
 protected:
  void SetUp() override { replace_folder(data_, example_files()); }
  TemporaryFolder folder_;
  fs::path data_ = folder_.path() / "new" / "data";
};

TEST_F(ReferenceFolderTest, PassesItsOwnCheck) {
  const auto answer = check(data_);
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_EQ(answer.err, "");
  EXPECT_THAT(answer.out,
              AllOf(HasSubstr("trajectories/power.csv: 27 rows, 27 recomputed, 0 wrong\n"),
                    HasSubstr(recomputed() + "all hold; worst ratio "), Not(HasSubstr("absent"))));
}

// The parameters of a table without a description are a guess; the check only reports that it is not wrong.
TEST_F(ReferenceFolderTest, ATableWithoutItsJsonIsNotSaidToHold) {
  for (const auto* name : {"index.json", "SHA256SUMS", "trajectories/power.json"}) fs::remove(data_ / name);
  EXPECT_THAT(printed(check(data_)),
              AllOf(HasSubstr(recomputed() +
                              "none is wrong, but 1 without a JSON does not say what it is; worst ratio "),
                    Not(HasSubstr("hold"))));
}

TEST_F(ReferenceFolderTest, AWrongDigitIsFoundAndItsRowNamed) {
  change(data_ / "trajectories/power.csv", "\n12,144.", "\n12,145.");
  const auto answer = check(data_);
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.out,
              AllOf(HasSubstr("27 recomputed, 1 wrong\n"),
                    HasSubstr("trajectories/power.csv: CHECKSUM DIFFERS\n"), HasSubstr("t=12 y=145.00000")));
  EXPECT_THAT(answer.err,
              StartsWith("fdebench: trajectories/power.csv: 1 of 27 rows wrong, the worst in line 20, y: "
                         "error 1.00e+00, allowed "));
}

TEST_F(ReferenceFolderTest, AChangeThatLeavesTheNumbersRightIsToldByItsChecksum) {
  for (const auto* name : {"convergence/power.json", "index.json"}) {
    replace_folder(data_, example_files());
    change(data_ / name, R"("commit": ")", R"("commit": "my)");
    EXPECT_THAT(check(data_),
                fails_with(2, fmt::format("fdebench: {}: all rows hold, but its checksum differs\n", name)));
  }
}

// A CSV and its JSON without the rest of the folder.
TEST_F(ReferenceFolderTest, TheChecksumOfADescriptionCountsToo) {
  fs::remove(data_ / "SHA256SUMS");
  change(data_ / "trajectories/power.csv", "\n12,144.", "\n12,+144.");
  EXPECT_THAT(check(data_),
              fails_with(2, "fdebench: trajectories/power.csv: all rows hold, but its checksum differs\n"));
}

TEST_F(ReferenceFolderTest, AMissingFileIsNamed) {
  fs::remove(data_ / "convergence/power.csv");
  EXPECT_THAT(check(data_), fails_with(2, HasSubstr("convergence/power.csv: cannot be read: No such file")));
}

TEST_F(ReferenceFolderTest, IsReplacedByNewTablesAndLeavesNothingElse) {
  change(data_ / "index.json", "fdebench", "other");
  require_replaceable(data_, example_tables());
  replace_folder(fs::path(data_.string() + "/"), example_files());
  EXPECT_EQ(read_file(data_ / "index.json"), example_files().at("index.json"));
  EXPECT_EQ(names_in(data_.parent_path()), std::set<std::string>{"data"});
}

// Without files no new folder is written: the last rename fails.
TEST_F(ReferenceFolderTest, IsThereAgainWhereItCannotBeReplaced) {
  EXPECT_THAT([&] { replace_folder(data_, {}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("data: cannot be written: No such file")));
  for (const auto& [name, text] : example_files()) EXPECT_EQ(read_file(data_ / name), text);
  EXPECT_EQ(names_in(data_.parent_path()), std::set<std::string>{"data"});
}

TEST_F(ReferenceFolderTest, AFolderWithOtherFilesIsRefusedAndKept) {
  std::ofstream(data_ / "thesis.tex") << "years";
  EXPECT_THAT(
      [&] { require_replaceable(data_, example_tables()); },
      ThrowsMessage<std::invalid_argument>(HasSubstr("cannot be written: holds thesis.tex, which is not")));
  std::ostringstream out, err;
  EXPECT_EQ(run_fdebench({"reference", "--out", data_.string()}, {.out = out, .err = err}), 2);
  EXPECT_EQ(read_file(data_ / "thesis.tex"), "years");
}

TEST(ReferenceFolder, IsNoFile) {
  const TemporaryFolder folder;
  folder.write("data", "");
  for (const auto* path : {"data", "data/below"}) {
    EXPECT_THAT([&] { require_replaceable(folder.path() / path, example_tables()); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("cannot be written: ")))
        << path;
  }
}

// A name too long for the file system makes the writing fail halfway.
TEST(ReferenceFolder, AFailureLeavesNothingBehind) {
  const TemporaryFolder folder;
  auto files = example_files();
  files["z/" + std::string(300, 'z')] = "";
  EXPECT_THAT([&] { replace_folder(folder.path() / "data", files); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("data: cannot be written: File name too long")));
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
}

TEST(ReferenceCommand, WantsOneOfOutAndCheck) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{{},
                                                                     {"--out", "a", "--check", "b"},
                                                                     {"--out", "a", "--every", "2"},
                                                                     {"--check", "a", "--every", "0"}}) {
    std::vector<std::string> all{"reference"};
    std::ranges::copy(arguments, std::back_inserter(all));
    std::ostringstream out, err;
    EXPECT_EQ(run_fdebench(all, {.out = out, .err = err}), 2);
    EXPECT_THAT(err.str(), StartsWith("fdebench: "));
  }
}

}  // namespace
}  // namespace fde::bench
