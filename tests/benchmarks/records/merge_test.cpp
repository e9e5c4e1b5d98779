// SPDX-License-Identifier: MIT
// Merging the results of several machines, and splitting sweeps into shards.

#include "fdebench/benchmarks/records/merge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/benchmarks/sweep/shard.hpp"
#include "fdebench/benchmarks/sweep/trials.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

class Merges : public testing::Test {
 protected:
  // A file with one session on a machine and one examination for each number of steps.
  [[nodiscard]] std::filesystem::path file_of(const std::string& name, const std::string& machine,
                                              const std::vector<int>& steps) const {
    Session session{};
    session.machine = machine;
    std::string text = line_of(session);
    for (const int n : steps) {
      Record run{
          .key = {.scene = {"power"}, .scheme = "l1", .settings = {.resolution = n}}, .steps = n, .end = 1.0};
      run.values.set("error_end", 1.0 / n);
      text += line_of(run);
    }
    folder_.write(name, text);
    return folder_.path() / name;
  }

  static std::vector<int> steps_of(const Results& results, const std::string& machine) {
    std::vector<int> steps;
    for (const Record& run : results.records) {
      if (results.sessions[run.session].machine == machine) steps.push_back(run.steps);
    }
    return steps;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path out_ = folder_.path() / "all.jsonl";
};

TEST_F(Merges, KeepTheSessionsOfSeveralMachinesApart) {
  const auto merged = merge_results({file_of("a", "one", {8, 16}), file_of("b", "other", {16, 32})}, out_);
  EXPECT_EQ(merged.sessions, 2U);
  EXPECT_EQ(merged.rows, 4U);
  const auto results = read_results(out_);
  ASSERT_EQ(results.sessions.size(), 2U);
  EXPECT_THAT(steps_of(results, "one"), ElementsAre(8, 16));
  EXPECT_THAT(steps_of(results, "other"), ElementsAre(16, 32));
}

TEST_F(Merges, OfOneFileAreThatFile) {
  const auto file = file_of("a", "one", {8, 16});
  merge_results({file}, out_);
  EXPECT_EQ(content_of(out_), content_of(file));
}

// A description of a scene is copied once for each session that has it.
TEST_F(Merges, KeepTheScenesThatAreDescribed) {
  const auto described = [&](const std::string& name, const std::string& machine) {
    auto file = file_of(name, machine, {8});
    auto text = content_of(file);
    text.insert(text.find('\n') + 1, line_of(SceneDescription{.scene = {"power"}, .title = "Power"}));
    folder_.write(name, text);
    return file;
  };
  const auto merged =
      merge_results({described("a", "one"), described("b", "one"), described("c", "other")}, out_);
  EXPECT_EQ(merged.rows, 2U);
  const auto results = read_results(out_);
  ASSERT_EQ(results.scenes.size(), 2U);
  EXPECT_EQ(results.scenes[0].title, "Power");
}

// Sessions that began in the same second on equal machines have equal session lines and count as one.
TEST_F(Merges, TakeWhatStandsInSeveralFilesOnce) {
  const auto merged = merge_results(
      {file_of("a", "one", {8, 16}), file_of("b", "one", {16, 32}), file_of("c", "one", {8})}, out_);
  EXPECT_EQ(merged.sessions, 1U);
  EXPECT_EQ(merged.rows, 3U);
  EXPECT_EQ(merged.repeated_rows, 2U);
  const auto results = read_results(out_);
  EXPECT_EQ(results.sessions.size(), 1U);
  EXPECT_THAT(steps_of(results, "one"), ElementsAre(8, 16, 32));
}

TEST_F(Merges, PassOverTheLastLineOfAKilledSweep) {
  const auto file = file_of("a", "one", {8, 16});
  const auto whole = content_of(file);
  folder_.write("cut", whole.substr(0, whole.size() - 20));
  merge_results({folder_.path() / "cut", file_of("b", "other", {32})}, out_);
  EXPECT_THAT(steps_of(read_results(out_), "one"), ElementsAre(8));
}

// Odd lines and runs without an ending are left out: what was merged is read without a warning.
TEST_F(Merges, LeaveOutWhatNoReaderAccepts) {
  const auto whole = content_of(file_of("a", "one", {8, 16, 32}));
  auto changed = whole;
  changed.replace(changed.rfind(R"("ending")"), 8, R"("finish")");
  folder_.write("odd", changed.insert(changed.find('\n') + 1, "garbage\n"));
  for (const bool of_two : {false, true}) {
    std::vector<std::filesystem::path> files{folder_.path() / "odd"};
    if (of_two) files.push_back(file_of("b", "one", {64}));
    const auto merged = merge_results(files, out_);
    ASSERT_EQ(merged.warnings.size(), 1U);
    EXPECT_THAT(merged.warnings[0], HasSubstr("odd: line 2 is not a row of fdebench results"));
    const auto results = read_results(out_);
    EXPECT_EQ(results.warning, "");
    EXPECT_EQ(steps_of(results, "one"), of_two ? (std::vector{8, 16, 64}) : (std::vector{8, 16}));
    std::filesystem::remove(out_);
  }
}

TEST_F(Merges, WriteNoFileThatIsThereAndNoneOfWhatIsNone) {
  const auto file = file_of("a", "one", {8});
  const auto before = content_of(file);
  EXPECT_THAT([&] { merge_results({file}, file); }, testing::ThrowsMessage<std::invalid_argument>(
                                                        file.string() + ": exists, it must be a new file"));
  EXPECT_EQ(content_of(file), before);
  folder_.write("other", "t,y\n");
  const auto other = folder_.path() / "other";
  EXPECT_THAT(
      [&] {
        merge_results({file, other}, out_);
      },
      testing::ThrowsMessage<std::invalid_argument>(other.string() +
                                                    ": line 1 is not a row of fdebench results"));
  EXPECT_FALSE(std::filesystem::exists(out_));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 2);
}

std::multiset<std::string> labels(const std::vector<Sweep>& sweeps) {
  std::multiset<std::string> all;
  for (const auto& sweep : sweeps) {
    for (const auto& scene : sweep.scenes) all.insert(scene.label() + (sweep.plan.goal ? " climbs" : ""));
  }
  return all;
}

// Each run of the default sweep is in one shard, and all runs of a scene are in the same.
TEST(Shards, AreAllOfASweepTogether) {
  const Sweep sweep{.scenes = sweep_scenes(), .schemes = sweep_schemes(), .plan = default_plan()};
  auto sweeps = sweeps_of_trials(sweep, false);
  sweeps.push_back(sweep);
  std::multiset<std::string> together;
  std::set<SceneSettings> scenes;
  std::size_t count = 0;
  for (int i = 1; i <= 3; ++i) {
    const auto shard = shard_of(sweeps, {.number = i, .count = 3});
    together.merge(labels(shard));
    std::set<SceneSettings> own;
    for (const auto& part : shard) {
      for (const auto& scene : part.scenes) own.insert(scene.key());
    }
    count += own.size();
    scenes.merge(own);
  }
  EXPECT_EQ(together, labels(sweeps));
  EXPECT_EQ(count, scenes.size());
}

TEST(Shards, BeyondTheScenesAreEmpty) {
  const Sweep sweep{.scenes = {{&scene_factory("power")}}, .schemes = sweep_schemes(), .plan = {{8}}};
  EXPECT_EQ(shard_of({sweep}, {.number = 1, .count = 2}).size(), 1U);
  EXPECT_TRUE(shard_of({sweep}, {.number = 2, .count = 2}).empty());
}

TEST(Shards, AreNumberedFromOneOn) {
  EXPECT_EQ(parse_shard("2/3").number, 2);
  EXPECT_EQ(parse_shard("2/3").count, 3);
  for (const auto* text : {"0/3", "4/3", "2", "/", "1/0", "a/b", "1/3/5"})
    EXPECT_THROW(parse_shard(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace fde::bench
