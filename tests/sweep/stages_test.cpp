#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "analysis/runs.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/record.hpp"

namespace fde {
namespace {

class Stages : public testing::Test {
 protected:
  static Record row(std::string_view quantity, double value, std::string_view status = "") {
    return {.scene = "power",
            .scheme = "l1",
            .history = "auto",
            .steps = 16,
            .h = 1.0 / 16,
            .quantity = std::string(quantity),
            .value = value,
            .unit = quantity.starts_with("time_") ? "s" : "1",
            .status = std::string(status)};
  }
  static std::vector<Record> examination(std::string_view status = "finished") {
    return {row("error_end", 0.1), row("outcome", 1.0, status)};
  }
  static std::vector<Record> times() { return {row("time_minimum", 0.5), row("time_median", 0.6, "timed")}; }

  [[nodiscard]] Stage stage() const { return ResultsFile(file_).stage("power", "l1", 16); }
  [[nodiscard]] std::string text() const {
    std::ostringstream all;
    all << std::ifstream(file_).rdbuf();
    return all.str();
  }
  void write(const std::string& content) const { std::ofstream(file_) << content; }

  // Another commit in the file's session number `session`.
  void change_build(int session) const {
    const std::string commit = R"("commit":")";
    auto changed = text();
    std::size_t place = 0;
    for (int i = 0; i <= session; ++i) place = changed.find(commit, place) + commit.size();
    write(changed.insert(place, "x"));
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "results.jsonl";
};

TEST_F(Stages, GoFromMissingToExaminedToDone) {
  EXPECT_EQ(stage(), Stage::missing);
  ResultsFile(file_).append(examination());
  EXPECT_EQ(stage(), Stage::examined);
  ResultsFile(file_).append(times());
  EXPECT_EQ(stage(), Stage::done);
}

TEST_F(Stages, OfRunsThatDidNotFinishAreDone) {
  ResultsFile(file_).append(examination("refused: no"));
  EXPECT_EQ(stage(), Stage::done);
}

// A continued run examines it, so that the file ends complete.
TEST_F(Stages, OfATimedRunWithoutAnExaminationIsMissing) {
  ResultsFile(file_).append(times());
  EXPECT_EQ(stage(), Stage::missing);
  ResultsFile(file_).append(examination());
  EXPECT_EQ(stage(), Stage::examined);
}

// What a kill leaves is a prefix of the file: the rows of whole writes are kept, whatever they are.
TEST_F(Stages, OfAFileCutAnywhereAreThoseOfItsWholeWrites) {
  {
    ResultsFile file(file_);
    file.append(examination());
    file.append(times());
  }
  const auto whole = text();
  const auto examined = whole.find('\n', whole.find("outcome")) + 1;
  for (std::size_t length = whole.size() % 3; length <= whole.size(); length += 3) {
    write(whole.substr(0, length));
    const std::size_t kept = length < examined ? 0 : length < whole.size() ? 2 : 4;
    EXPECT_EQ(read_results(file_).records.size(), kept) << length;
    EXPECT_EQ(stage(), kept == 0 ? Stage::missing : kept == 2 ? Stage::examined : Stage::done) << length;
  }
}

TEST_F(Stages, TimesOfALaterSessionJoinTheirExamination) {
  ResultsFile(file_).append(examination());
  ResultsFile(file_).append(times());
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished[0].values,
            (decltype(MeasuredRun::values){{"error_end", 0.1}, {"time_minimum", 0.5}, {"time_median", 0.6}}));
  EXPECT_EQ(runs.finished[0].session, 0U);
}

// A time stands beside the error of the program that took it.
TEST_F(Stages, TimesOfAnotherBuildDoNotJoin) {
  ResultsFile(file_).append(examination());
  ResultsFile(file_).append(times());
  change_build(1);
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished[0]["time_minimum"], std::nullopt);
  EXPECT_EQ(runs.failed.size(), 0U);
  EXPECT_EQ(stage(), Stage::examined);
}

TEST_F(Stages, ALaterExaminationReplacesTheEarlierWithItsTimes) {
  {
    ResultsFile file(file_);
    file.append(examination());
    file.append(times());
  }
  ResultsFile(file_).append({row("error_end", 0.2), row("outcome", 1.0, "finished")});
  const Runs runs = runs_of(read_results(file_));
  ASSERT_EQ(runs.finished.size(), 1U);
  EXPECT_EQ(runs.finished[0].values, (decltype(MeasuredRun::values){{"error_end", 0.2}}));
}

}  // namespace
}  // namespace fde
