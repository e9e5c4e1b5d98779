// SPDX-License-Identifier: MIT
// fdebench plot: what it says where it cannot draw, and which runs it draws.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

class Plots : public testing::Test {
 protected:
  [[nodiscard]] std::string drawn_text() const { return content_of(folder_.path() / "figure.vl.json"); }
  const TemporaryFolder folder_;
};

TEST_F(Plots, NameTheColumnsThatThereAre) {
  EXPECT_THAT(
      fdebench("plot relaxation_pair --kind solution --columns lambda1 --out " + folder_.file("figure.svg")),
      fails_with(2, HasSubstr("fdebench: --columns = lambda1: must be of x, y")));
}

TEST_F(Plots, NameTheProgramThatIsNotInstalled) {
  const std::string before = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const auto drawn = fdebench("plot relaxation --kind solution --out " + folder_.file("figure.vl.json"));
  setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(drawn.code, 2);
  EXPECT_THAT(drawn.err, HasSubstr("node of Debian's nodejs draws figures, and is not installed\n"));
}

TEST_F(Plots, TakeAScaleWhereErrorsAreDrawn) {
  EXPECT_EQ(
      fdebench("run --scene relaxation --scheme l1 --steps 16,32 --out " + folder_.file("few.jsonl")).code,
      0);
  const auto results = " --results " + folder_.file("few.jsonl"),
             out = " --out " + folder_.file("figure.vl.json");
  expect_success(fdebench("plot relaxation --kind rate --scale peak" + results + out));
  EXPECT_THAT(drawn_text(), HasSubstr("peak maximum error"));
  EXPECT_THAT(fdebench("plot relaxation --kind solution --scale peak" + out).err,
              HasSubstr("--scale = peak: --kind solution draws no errors"));
}

// The error of l1 for t^2 at the end is exact for no step; its order is 2 - gamma.
TEST_F(Plots, OfOrdersAreTables) {
  ASSERT_EQ(fdebench("run --scene power --scheme l1 --scheme spectral_collocation --steps 64,128,256 "
                     "--accuracy 1e-3 --out " +
                     folder_.file("few.jsonl"))
                .code,
            0);
  const auto table = [&](const std::string& name, const std::string& more = "") {
    expect_success(fdebench("plot power --kind orders --results " + folder_.file("few.jsonl") + " --out " +
                            folder_.file(name) + more));
    return content_of(folder_.file(name));
  };
  const auto csv = table("orders.csv", " --norm end");
  EXPECT_THAT(csv, testing::StartsWith("scheme,steps,h,error,order,expected\nl1,64,0.015625,"));
  EXPECT_THAT(csv, testing::ContainsRegex("\nl1,256,0.00390625,[0-9.e-]+,1\\.[45][0-9]*,1\\.5\n$"));
  const auto tex = table("orders.tex");
  EXPECT_THAT(
      tex, testing::StartsWith("\\begin{tabular}{r*{1}{lr}}\n\\hline\n$N$ & \\multicolumn{2}{c}{l1} \\\\\n"));
  EXPECT_THAT(
      tex, testing::ContainsRegex("\n128 & \\$[0-9.]+\\\\cdot10\\^\\{-[0-9]\\}\\$ & \\$1\\.[45][0-9]\\$ "));
  EXPECT_THAT(tex, testing::EndsWith("\\end{tabular}\n"));
  EXPECT_THAT(
      fdebench("plot power --kind orders --results " + folder_.file("few.jsonl") + " --out a.svg").err,
      HasSubstr("--out = a.svg: must end in .tex or .csv, as a table"));
  EXPECT_THAT(
      fdebench("plot power --kind orders --scheme bdf2 --out a.csv --results " + folder_.file("few.jsonl"))
          .err,
      HasSubstr("--scheme = bdf2: must be of l1, spectral_collocation"));
}

// The solution of `power` is t^2: the measurement at 0.5 leaves 0.05, that at 1 nothing; one is missing.
TEST_F(Plots, OfResidualsHaveWhatTheSolutionLeaves) {
  folder_.write("data.csv", "t,y,sd_y\n0.5,0.3,0.1\n0.7,,\n1,1,0.2\n");
  const auto out = " --out " + folder_.file("figure.vl.json"), data = " --data " + folder_.file("data.csv");
  expect_success(fdebench("plot power --kind residuals" + data + out));
  const auto panels = nlohmann::json::parse(drawn_text())["vconcat"];
  const auto left = panels[1]["layer"].back()["data"]["values"];
  ASSERT_EQ(left.size(), 2U);
  EXPECT_NEAR(left[0]["residual"], 0.05, 1e-15);
  EXPECT_NEAR(left[0]["high"], 0.15, 1e-15);
  EXPECT_NEAR(left[1]["residual"], 0.0, 1e-15);
  EXPECT_THAT(fdebench("plot power --kind residuals" + out).err, HasSubstr("needs a file of them"));
  EXPECT_THAT(fdebench("plot power --kind solution" + data + out).err,
              HasSubstr("--kind solution draws no measurements"));
}

// The runs of all formulations, whichever the scene names.
TEST_F(Plots, OfDriftsHaveAllFormulations) {
  std::string run = "run --scheme product_trapezoidal --steps 32,64 --out " + folder_.file("drift.jsonl");
  for (const auto* form : {"acceleration", "multiplier"})
    run += std::string(" --scene fractional_knife_edge:until=1,formulation=") + form;
  ASSERT_EQ(fdebench(run).code, 0);
  for (const auto* scene :
       {"fractional_knife_edge:until=1", "fractional_knife_edge:until=1,formulation=multiplier"}) {
    expect_success(fdebench(std::string("plot ") + scene + " --kind drift --results " +
                            folder_.file("drift.jsonl") + " --out " + folder_.file("figure.vl.json")));
    for (const auto* form : {"acceleration", "multiplier"})
      EXPECT_THAT(drawn_text(), HasSubstr(form)) << scene;
  }
}

}  // namespace
}  // namespace fde::bench
