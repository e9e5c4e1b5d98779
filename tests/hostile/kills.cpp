// SPDX-License-Identifier: MIT
// fde_kill_test FDEBENCH KILLS: runs a small sweep in a process of its own, ends it by a signal at a random
// moment, resumes it, and so on. After each kill the file must be readable and begin with the runs that were
// complete before; at the end it must contain each run once, with the values of an uninterrupted sweep.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace fde;
using namespace fde::bench;
namespace fs = std::filesystem;

pid_t start(const std::string& program, const fs::path& file) {
  const std::vector<std::string> words{program,    "run", "--scene",  "power",      "--scene", "relaxation",
                                       "--scheme", "l1",  "--scheme", "adams_pc",   "--steps", "8,64,512",
                                       "--repeat", "1",   "--out",    file.string()};
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child > 0) return child;
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  execv(program.c_str(), arguments.data());
  _exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

// The examined runs, and the keys of the timed ones.
std::vector<std::string> values(const Results& results) {
  std::vector<std::string> lines;
  for (Record run : results.records) {
    if (!run.timing.values.empty()) lines.push_back(line_of(LaterTimes{run.key}));
    run.timing = {};
    lines.push_back(line_of(run));
  }
  std::ranges::sort(lines);
  return lines;
}

class KillTest {
 public:
  KillTest(std::string program, unsigned seed) : program_(std::move(program)), random_(seed) {
    const int status = wait_for(start(program_, folder_.path() / "whole.jsonl"));
    require(status == 0, "the sweep that nobody kills fails");
    whole_ = values(read_results(folder_.path() / "whole.jsonl"));
  }

  void operator()(int kills) {
    while (killed_ < kills) {
      fs::remove(file_);
      while (killed_ < kills && run_and_kill()) {
      }
      if (killed_ == kills) require(wait_for(start(program_, file_)) == 0, "a last run fails");
      require(values(read_results(file_)) == whole_, "the values are others than those of an unkilled sweep");
      ++sweeps_;
    }
    fmt::print("{} kills of {} sweeps, {} lines each: no complete line lost, none measured twice\n", killed_,
               sweeps_, whole_.size());
  }

 private:
  // Starts one run and kills it; false if it finished before.
  bool run_and_kill() {
    constexpr std::array signals{SIGKILL, SIGINT, SIGTERM, SIGKILL, SIGHUP};
    const pid_t child = start(program_, file_);
    std::this_thread::sleep_for(std::chrono::microseconds(delay_(random_)));
    const std::string before = content_of(file_);
    kill(child, signals[static_cast<std::size_t>(killed_) % signals.size()]);
    const int status = wait_for(child);
    if (WIFEXITED(status)) {
      require(WEXITSTATUS(status) == 0, "a continued run fails");
      return false;
    }
    ++killed_;
    const auto complete = lines_of(before), after = lines_of(fs::exists(file_) ? content_of(file_) : "");
    require(std::ranges::includes(after, complete), "complete lines are lost");
    return true;
  }

  [[nodiscard]] std::vector<std::string> lines_of(const std::string& text) const {
    const auto copy = folder_.path() / "copy.jsonl";
    std::ofstream(copy, std::ios::binary) << text;
    return values(read_results(copy));
  }

  std::string program_;
  std::mt19937 random_;
  std::uniform_int_distribution<int> delay_{0, 150'000};
  TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "results.jsonl";
  std::vector<std::string> whole_;
  int killed_ = 0, sweeps_ = 0;
};

// The number, or 0 if the text is not a whole number.
int number_of(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
  return error == std::errc{} && end == text.end() ? number : 0;
}

}  // namespace

int main(int count, char** arguments) {
  const int kills = count == 3 ? number_of(arguments[2]) : 0;
  if (kills < 1) {
    fmt::print(stderr, "usage: fde_kill_test FDEBENCH KILLS, at least 1\n");
    return 2;
  }
  try {
    const unsigned seed = std::random_device()();
    fmt::print("seed {}\n", seed);
    KillTest test(arguments[1], seed);
    test(kills);
    return 0;
  } catch (const std::exception& failure) {
    fmt::print(stderr, "kill test: {}\n", failure.what());
    return 1;
  }
}
