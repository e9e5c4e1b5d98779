// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "fdebench/reports/command/command.hpp"
#include "support/matchers.hpp"  // IWYU pragma: export

namespace fde::bench {

// The exit code and output of the command, run in this process.
struct CommandOutput {
  int code;
  std::string out, err;
};

inline CommandOutput fdebench(const std::vector<std::string>& arguments,
                              const SceneRegistry& known = built_in_scenes()) {
  std::ostringstream out, err;
  const int code = run_fdebench(arguments, {.out = out, .err = err}, known);
  return {code, out.str(), err.str()};
}

inline void expect_success(const CommandOutput& answer) { EXPECT_EQ(answer.code, 0) << answer.err; }

// What a command prints that has to succeed.
inline std::string printed(const CommandOutput& answer) {
  expect_success(answer);
  return answer.out;
}

using TextMatcher = testing::Matcher<const std::string&>;

inline std::ostream& operator<<(std::ostream& stream, const CommandOutput& answer) {
  return stream << "exit code " << answer.code << '\n' << answer.out << answer.err;
}

// A command that ends with this exit code and such a message.
inline testing::Matcher<const CommandOutput&> fails_with(int code, const TextMatcher& message) {
  return AllOf(testing::Field("code", &CommandOutput::code, code),
               testing::Field("err", &CommandOutput::err, message));
}

// One that prints nothing but its message, in one line.
inline testing::Matcher<const CommandOutput&> is_refused(int code, const TextMatcher& message) {
  const auto is_one_line =
      testing::ResultOf([](const std::string& text) { return std::ranges::count(text, '\n'); }, 1);
  return AllOf(fails_with(code, AllOf(is_one_line, message)), testing::Field("out", &CommandOutput::out, ""));
}

}  // namespace fde::bench
