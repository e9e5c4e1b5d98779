// SPDX-License-Identifier: MIT
// fdebench solve --checkpoint: the same command continues from the file, prints the bits of an uninterrupted
// run, and rejects other files.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>

#include "support/command_line_result.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

class CheckpointOfSolve : public testing::Test {
 protected:
  [[nodiscard]] std::string file() const { return folder_.file("state"); }
  [[nodiscard]] std::string content() const { return content_of(file()); }
  void replace(const std::string& text) const { folder_.write("state", text); }
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  }

  static constexpr auto plain = "solve pendulum --scheme product_trapezoidal --steps 20000 --points 5";

  [[nodiscard]] CommandOutput solve_with_checkpoint(const std::string& command) const {
    return fdebench(command + " --checkpoint " + file());
  }
  // Writes the state of a run that was ended early.
  void write_state() const {
    const auto ended = solve_with_checkpoint(std::string(plain) + " --checkpoint-every 0 --budget 0.02");
    ASSERT_EQ(ended.code, 3) << ended.err;
    ASSERT_TRUE(fs::exists(file()));
  }

  const TemporaryFolder folder_;
};

TEST_F(CheckpointOfSolve, IsGoneAtTheEnd) {
  const auto [code, out, err] =
      solve_with_checkpoint("solve relaxation --scheme l1 --steps 200 --checkpoint-every 0");
  EXPECT_EQ(code, 0) << err;
  EXPECT_EQ(out, fdebench("solve relaxation --scheme l1 --steps 200").out);
  EXPECT_EQ(err, "");
  EXPECT_EQ(files(), 0);
}

TEST_F(CheckpointOfSolve, ContinuesToTheBitsOfAWholeRun) {
  write_state();
  // Budget, threads and additional output may differ.
  const auto [code, out, err] = solve_with_checkpoint(std::string(plain) + " --threads 2 --cost");
  EXPECT_EQ(code, 0);
  EXPECT_EQ(out, fdebench(plain).out);
  EXPECT_THAT(err, HasSubstr(R"("continued":true)"));
  EXPECT_EQ(files(), 0);
}

TEST_F(CheckpointOfSolve, IsOfOneRunOnly) {
  write_state();
  const auto kept = content();
  const std::vector<std::pair<std::string, std::string>> others{
      {"solve pendulum --scheme l1 --steps 20000 --points 5", "scheme = product_trapezoidal, not l1"},
      {"solve pendulum --scheme product_trapezoidal --steps 20001 --points 5",
       "steps = N = 20000, not N = 20001"},
      {"solve pendulum:alpha=1.7 --scheme product_trapezoidal --steps 20000 --points 5", "scene = "},
      {"solve relaxation --scheme product_trapezoidal --steps 20000 --points 5", "scene = "},
      {std::string(plain) + " --until 3", "end = 20, not 3"},
      {std::string(plain) + " --grid graded:2", "grid = uniform, not graded:2"},
      {std::string(plain) + " --history direct", "history = auto, not direct"},
      {std::string(plain) + " --tolerance 1e-6", "tolerance = 1e-15, not 1e-06"},
      {"solve pendulum --scheme product_trapezoidal --steps 20000 --at 20", "times = points 5, not at 20"}};
  for (const auto& [command, difference] : others) {
    EXPECT_THAT(solve_with_checkpoint(command),
                is_refused(2, StartsWith("fdebench: " + file() + ": is of another run: " + difference)))
        << command;
  }
  EXPECT_EQ(content(), kept);
}

TEST_F(CheckpointOfSolve, IsRefusedWhereItIsDamaged) {
  write_state();
  const auto kept = content();
  for (const std::size_t at : {std::size_t{40}, kept.size() / 2, kept.size() - 100, kept.size() - 1}) {
    auto damaged = kept;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    replace(damaged);
    const auto [code, out, err] = solve_with_checkpoint(plain);
    EXPECT_EQ(code, 2) << at;
    EXPECT_EQ(err, "fdebench: " + file() + ": is damaged: its checksum is of something else\n") << at;
  }
  for (const std::size_t size : {std::size_t{30}, std::size_t{100}, kept.size() / 3, kept.size() - 1}) {
    replace(kept.substr(0, size));
    const auto [code, out, err] = solve_with_checkpoint(plain);
    EXPECT_EQ(code, 2) << size;
    EXPECT_EQ(err, "fdebench: " + file() + ": is damaged: its checksum is of something else\n") << size;
  }
}

TEST_F(CheckpointOfSolve, ReplacesNoFileOfAnotherKind) {
  for (const auto& text : std::vector<std::string>{"", "{", "t,y\n0,1\n"}) {
    replace(text);
    EXPECT_THAT(solve_with_checkpoint(plain),
                fails_with(2, "fdebench: " + file() + ": is no checkpoint, and is not replaced by one\n"));
    EXPECT_EQ(content(), text);
  }
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_EQ(solve_with_checkpoint(plain).err, "fdebench: " + file() + ": is no file\n");
}

TEST_F(CheckpointOfSolve, NeedsAFolderAndNumbers) {
  const auto missing = folder_.file("missing/state");
  EXPECT_EQ(fdebench(std::string(plain) + " --checkpoint " + missing).err,
            "fdebench: " + missing + ": cannot be written: No such file or directory\n");
  EXPECT_THAT(solve_with_checkpoint(std::string(plain) + " --checkpoint-every x").err,
              HasSubstr("--checkpoint-every = x"));
  EXPECT_THAT(fdebench(std::string(plain) + " --checkpoint-every 5").err,
              HasSubstr("--checkpoint-every = 5: must be with --checkpoint"));
  EXPECT_EQ(files(), 0);
}

TEST_F(CheckpointOfSolve, IsRefusedForSchemesThatKeepNone) {
  for (const auto* scheme : all_schemes()) {
    if (scheme->capabilities.checkpoints) continue;
    const auto* const resolution = !scheme->capabilities.is_adaptive() ? " --steps 8" : " --accuracy 1e-3";
    EXPECT_THAT(solve_with_checkpoint("solve relaxation --scheme " + std::string(scheme->id) + resolution),
                fails_with(2, HasSubstr(std::string(scheme->id) + " keeps no checkpoints")));
  }
  EXPECT_THAT(solve_with_checkpoint("solve two_sided_constraint --scheme grunwald_letnikov --steps 8").err,
              HasSubstr("keeps no checkpoints of a problem that it solves at all times at once"));
}

// The run continues, reports the failure once, and keeps the earlier state.
TEST_F(CheckpointOfSolve, MayFindAFullDisk) {
  write_state();
  const auto kept = content();
  const auto whole = fdebench(plain);
  {
    const FullDisk full(100);
    const auto [code, out, err] =
        solve_with_checkpoint(std::string(plain) + " --checkpoint-every 0 --budget 0.05");
    EXPECT_EQ(code, 3);
    EXPECT_THAT(err, StartsWith("fdebench: " + file() + ": cannot be written: File too large\n"));
    EXPECT_EQ(std::ranges::count(err, '\n'), 2) << err;
    EXPECT_EQ(content(), kept);
    EXPECT_EQ(files(), 1);
    EXPECT_EQ(solve_with_checkpoint(std::string(plain) + " --checkpoint-every 0.001").out, whole.out);
  }
  EXPECT_EQ(files(), 0);
}

// Temporary files of a live process belong to another run; no process has the largest id.
TEST_F(CheckpointOfSolve, RemovesWhatKilledRunsLeft) {
  folder_.write("state.2147483647.0.tmp", "half");
  folder_.write("state.2147483647.tmp", "of another kind");
  folder_.write(fmt::format("state.{}.7.tmp", getpid()), "at work");
  EXPECT_EQ(solve_with_checkpoint("solve relaxation --scheme l1 --steps 20").code, 0);
  EXPECT_FALSE(fs::exists(folder_.path() / "state.2147483647.0.tmp"));
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace fde::bench
