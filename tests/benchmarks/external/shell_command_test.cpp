// SPDX-License-Identifier: MIT
// Shell commands as processes: how they end, and that no child process is left.

#include "fdebench/benchmarks/external/shell_command.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>

#include "fdebench/benchmarks/external/process_cleanup.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

using Status = CommandResult::Status;

class ShellCommands : public testing::Test {
 protected:
  CommandResult run(const std::string& command, double seconds = 30.0, std::uint64_t bytes = 1 << 20) {
    return run_command(command, R"(a 'b' "c" $d\)", out_.descriptor(), err_.descriptor(), {seconds, bytes});
  }

  // Whether the process with this id exists and is no zombie.
  static bool is_alive(long pid) {
    const auto facts = content_of(fmt::format("/proc/{}/stat", pid));
    const auto name_end = facts.rfind(") ");
    return name_end != std::string::npos && facts[name_end + 2] != 'Z';
  }

  // Expects that the process whose id is in this file ends within ten seconds.
  static void expect_gone(const std::filesystem::path& file) {
    const long pid = std::stol(content_of(file));
    ASSERT_GT(pid, 1);
    for (int i = 0; i < 1000 && is_alive(pid); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(is_alive(pid));
  }

  const TemporaryFile out_{".out"}, err_{".err"};
  const TemporaryFolder folder_;
  const std::string pid_ = folder_.file("pid");
};

TEST_F(ShellCommands, TakeTheArgumentUnchangedAsTheirLastWord) {
  const auto end = run("printf '%s|' one");
  EXPECT_EQ(end.status, Status::exited);
  EXPECT_EQ(end.code, 0);
  EXPECT_EQ(content_of(out_.path()), R"(one|a 'b' "c" $d\|)");
}

TEST_F(ShellCommands, TellTheirExitCodeAndTheirTime) {
  const auto end = run("sh -c 'sleep 0.2; echo no >&2; exit 3'");
  EXPECT_EQ(end.status, Status::exited);
  EXPECT_EQ(end.code, 3);
  EXPECT_GE(end.seconds, 0.2);
  EXPECT_EQ(content_of(err_.path()), "no\n");
  EXPECT_EQ(run("no_such_program_here").code, 127);
}

// A signal that kills the shell itself, or a command of the shell, which is reported as an exit code.
TEST_F(ShellCommands, TellTheSignalThatKilledThem) {
  for (const auto* command : {"kill -SEGV $$ #", "sh -c 'kill -SEGV $$'; exit $? #"}) {
    const auto end = run(command);
    EXPECT_EQ(end.status, Status::killed) << command;
    EXPECT_EQ(end.code, SIGSEGV) << command;
  }
}

TEST_F(ShellCommands, HaveNothingToRead) { EXPECT_EQ(run("cat #").status, Status::exited); }

TEST_F(ShellCommands, EndWithAllTheyStartedWhenTheirTimeIsOver) {
  const auto end = run("trap '' TERM INT; sleep 100 & echo $! > " + pid_ + "; sleep 100 #", 0.3);
  EXPECT_EQ(end.status, Status::out_of_time);
  EXPECT_GE(end.seconds, 0.3);
  EXPECT_LT(end.seconds, 10.0);
  expect_gone(pid_);
}

TEST_F(ShellCommands, LeaveNoProcessBehind) {
  const auto end = run("sleep 100 & echo $! > " + pid_ + " #");
  EXPECT_EQ(end.status, Status::exited);
  EXPECT_LT(end.seconds, 10.0);
  expect_gone(pid_);
}

TEST_F(ShellCommands, EndWhenTheyWriteTooMuch) {
  EXPECT_EQ(run("yes #").status, Status::too_much_output);
  EXPECT_EQ(run("yes >&2 #").status, Status::too_much_output);
}

}  // namespace
}  // namespace fde::bench
