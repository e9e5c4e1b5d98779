// SPDX-License-Identifier: MIT
// Commands on equation files that a test writes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {

// The output of a command whose first argument is a file with this text.
inline CommandOutput command(const std::string& text, std::vector<std::string> words) {
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  words.insert(words.begin() + 1, folder.file("f.toml"));
  return fdebench(words);
}

// The last row of the output: t and the columns.
inline std::vector<double> values(const CommandOutput& answer) {
  EXPECT_EQ(answer.err, "");
  std::vector<double> row;
  const auto line = answer.out.rfind('\n', answer.out.size() - 2);
  for (std::size_t at = line; at != std::string::npos; at = answer.out.find(',', at + 1))
    row.push_back(std::stod(answer.out.substr(at + 1)));
  return row;
}

// t, the columns of the reference and its bound.
inline std::vector<double> exact(const std::string& text, std::string_view t) {
  return values(command(text, {"exact", "--at", std::string(t)}));
}

// The error of the first column at the end of a run with this number of steps.
inline double error_at_end(const std::string& text, std::string_view end, std::string_view scheme,
                           std::string_view steps) {
  const auto run = command(text, {"solve", "--scheme", std::string(scheme), "--steps", std::string(steps),
                                  "--at", std::string(end)});
  return std::abs(values(run)[1] - exact(text, end)[1]);
}

}  // namespace fde::bench
