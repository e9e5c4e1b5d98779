// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "support/message_of.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {

// A results file in a folder of its own, as text and as it is opened.
class ResultsFileTest : public testing::Test {
 protected:
  [[nodiscard]] std::string text() const { return content_of(file_); }
  void write(const std::string& content) const { std::ofstream(file_) << content; }

  // Why the file cannot be opened, or what is left out of it; "opened" if it can, and nothing is.
  static std::string message(const std::filesystem::path& file) {
    std::string warning;
    const auto refusal = message_of<std::invalid_argument>([&] { warning = ResultsFile(file).warning(); });
    return refusal != "accepted" ? refusal : warning.empty() ? "opened" : warning;
  }

  // The message, without the name of the file, once `from` is replaced by `to` in its text `whole`.
  [[nodiscard]] std::string message_of_change(std::string whole, const std::string& from,
                                              const std::string& to) const {
    const auto at = whole.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    write(whole.replace(at, from.size(), to));
    return message(file_).substr(file_.string().size());
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path(), file_ = folder_ / "results.jsonl";
};

}  // namespace fde::bench
