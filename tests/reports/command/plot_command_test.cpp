// SPDX-License-Identifier: MIT
// fdebench plot: what it says where it cannot draw, and which runs it draws.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
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
