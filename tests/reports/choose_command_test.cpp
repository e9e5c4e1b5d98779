// fdebench choose: that what it says holds.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/answer_of_words.hpp"

namespace fde {
namespace {

using testing::HasSubstr;

TEST(Choose, MakesTheRunThatItNames) {
  const auto choice = fdebench("choose power --set p=1.83 --error 1e-4 --json --max-time 5");
  EXPECT_EQ(choice.code, 0) << choice.err;
  const auto json = nlohmann::json::parse(choice.out);
  EXPECT_LE(json["error"], 1e-4);
  EXPECT_LE(json["seconds_low"], json["seconds"]);
  EXPECT_GE(json["seconds_high"], json["seconds"]);
  const std::string command = json["command"];
  const auto again = fdebench(command.substr(command.find(' ') + 1));
  EXPECT_EQ(again.code, 0) << again.err;
  double worst = 0.0;
  for (const auto& row : csv_rows(again.out)) {
    const double exact = std::pow(row[0], 1.83);
    worst = std::max(worst, std::abs(row[1] - exact) / (1.0 + exact));
  }
  EXPECT_NEAR(worst / json["error"].get<double>(), 1.0, 1e-6);
}

TEST(Choose, SaysWhatWouldBeNeeded) {
  const auto choice = fdebench("choose bagley_torvik --error 1e-9 --max-time 2");
  EXPECT_EQ(choice.code, 3);
  EXPECT_EQ(choice.out, "");
  EXPECT_THAT(choice.err, HasSubstr("would need about N = "));
  EXPECT_EQ(std::ranges::count(choice.err, '\n'), 1);
}

// dy starts like the root of t, y does not.
TEST(Choose, CountsTheColumnsThatAreNamed) {
  const std::string words = "choose pendulum --until 2 --error 1e-4 --max-time 5 --json ";
  const auto all = nlohmann::json::parse(fdebench(words).out),
             one = nlohmann::json::parse(fdebench(words + "--columns phi").out);
  EXPECT_LT(one["seconds"], all["seconds"]);
  EXPECT_EQ(one["columns"], std::vector<std::string>{"phi"});
}

}  // namespace
}  // namespace fde
