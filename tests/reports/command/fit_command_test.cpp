// SPDX-License-Identifier: MIT
// Fits of y(t) = t^p, the solution of `power`, to measurements of t^2.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Fitting : public testing::Test {
 protected:
  [[nodiscard]] CommandOutput fit(const std::string& csv,
                                  std::vector<std::string> more = {"--vary", "p"}) const {
    folder_.write("data.csv", csv);
    std::vector<std::string> words{"fit", "power:p=1.5", file_};
    words.insert(words.end(), more.begin(), more.end());
    return fdebench(words);
  }

  const TemporaryFolder folder_;
  const std::string file_ = folder_.file("data.csv");
};

constexpr auto squares = "t,y,sd_y\n0.25,0.0625,0.01\n0.5,0.25,0.01\n0.5,0.25,0.02\n0.75,,\n1,1.01,0.01\n";

TEST_F(Fitting, PrintsALineForEachParameter) {
  const auto answer = fit(squares);
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, StartsWith("scene power:p="));
  EXPECT_THAT(answer.out, HasSubstr("\nrows 5\ncolumn y measurements 4 rms "));
  EXPECT_THAT(answer.out, HasSubstr("\nchi_squared 1\ndegrees_of_freedom 3\nprobability 0.801\n"));
  EXPECT_THAT(answer.out, HasSubstr("\nparameter p 2"));
  EXPECT_THAT(answer.out, HasSubstr("\nsolver spectral_collocation --accuracy 1e-08, "));
}

TEST_F(Fitting, WritesALineForEachMeasurement) {
  const auto left = folder_.file("left.csv");
  EXPECT_EQ(fit(squares, {"--vary", "p=1:", "--residuals", left}).code, 0);
  const auto text = content_of(left);
  EXPECT_THAT(text, StartsWith("t,column,measured,sd,model,residual\n0.25,y,0.0625,0.01,"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
}

// Under whatever name.
TEST_F(Fitting, OverwritesNothingThatItReads) {
  const auto link = folder_.file("link.csv");
  std::filesystem::create_symlink("data.csv", link);
  for (const auto& name : {file_, folder_.file("./data.csv"), link}) {
    const auto answer = fit(squares, {"--vary", "p", "--residuals", name});
    EXPECT_EQ(answer.err, "fdebench: --residuals = " + name + ": must be another file than " + file_ +
                              ", which is read\n");
    EXPECT_EQ(answer.code, 2);
    EXPECT_EQ(content_of(file_), squares);
  }
}

// In the middle of its limits, where the free variable is 0.
TEST_F(Fitting, StartsAnywhereBetweenItsLimits) {
  for (const std::string limits : {"1:2", "1.2:1.8", "1.45:4"}) {
    const auto answer = fit("t,y\n0.25,0.125\n0.5,0.354\n0.75,0.65\n1,1\n", {"--vary", "p=" + limits});
    EXPECT_EQ(answer.code, 0) << limits << answer.err;
    EXPECT_THAT(answer.out, HasSubstr("\nparameter p 1.")) << limits;
  }
}

TEST_F(Fitting, PrintsOneObject) {
  const auto answer =
      nlohmann::json::parse(fit("t,y\n0.5,0.26\n0.7,0.48\n1,1\n", {"--vary", "p", "--json"}).out);
  EXPECT_NEAR(answer["parameters"][0]["value"], 2.0, 0.1);
  EXPECT_EQ(answer["columns"][0]["measurements"], 3);
  EXPECT_FALSE(answer.contains("chi_squared"));
}

TEST_F(Fitting, NamesWhatItDoesNotTake) {
  const auto refused = [&](std::vector<std::string> more, const std::string& csv = squares) {
    const auto answer = fit(csv, std::move(more));
    EXPECT_EQ(answer.code, 2);
    EXPECT_EQ(answer.out, "");
    return answer.err;
  };
  EXPECT_EQ(refused({"--vary", "p=1"}),
            "fdebench: --vary = p=1: must be NAME or NAME=LOW:HIGH, with commas between them\n");
  EXPECT_THAT(refused({"--vary", "p=x:"}), HasSubstr("must be NAME or NAME=LOW:HIGH"));
  EXPECT_THAT(refused({"--vary", "q"}), HasSubstr("--vary: q: scene power has no such parameter"));
  EXPECT_THAT(refused({}), HasSubstr("--vary"));
  EXPECT_EQ(refused({"--vary", "p"}, "t,y\n0.5,0.25\n"),
            "fdebench: " + file_ +
                ": has 1 of at least 2 measurements: as many as parameters, and one more without standard "
                "deviations\n");
  EXPECT_EQ(refused({"--vary", "p"}, "t,y\n0.5,0.25\n0.4,1\n"),
            "fdebench: " + file_ + ": line 3: t = 0.4: must be at least 0.5, the time before\n");
  EXPECT_EQ(
      refused({"--vary", "p"}, "t,y\n0.5,inf\n0.6,1\n"),
      "fdebench: " + file_ + ": line 2: y = inf: must be a finite number, or empty where it is missing\n");
}

TEST_F(Fitting, WarnsOfALimit) {
  const auto answer = fit(squares, {"--vary", "p=1:1.8"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.out, HasSubstr("\nparameter p 1.8 at_limit\n"));
  EXPECT_THAT(answer.err, HasSubstr("fdebench: warning: p is at an end of its range, 1.8, "));
}

}  // namespace
}  // namespace fde::bench
