// SPDX-License-Identifier: MIT
// Derivatives on the right-hand side whose orders no term has: variable coefficients as they are written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

using testing::DoubleNear;
using testing::Pointwise;

// The first column at these times.
std::vector<double> first_column(const std::string& text, const std::string& times,
                                 const std::vector<std::string>& how) {
  const TemporaryFolder folder;
  folder.write("f.toml", text);
  std::vector<std::string> words{"solve", folder.path() / "f.toml", "--at", times, "--scheme"};
  words.insert(words.end(), how.begin(), how.end());
  const auto answer = fdebench(words);
  EXPECT_EQ(answer.err, "");
  std::istringstream lines(answer.out);
  std::vector<double> values;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) values.push_back(std::stod(line.substr(line.find(',') + 1)));
  return values;
}

const std::vector<std::string> spectral{"spectral_collocation", "--accuracy", "1e-11"};

// y = t^3 solves y'' + sin(t) D^0.5 y + t y = f.
TEST(VariableCoefficient, IsWrittenOnTheRight) {
  const std::string text =
      "end = 2\n[unknown.y]\nterms = [[1, 2], [0, 0.5]]\ninitial = [0, 0]\n"
      "rhs = \"6*t + sin(t)*6/gamma(3.5)*t^2.5 + t^4 - sin(t)*D(y, 0.5) - t*y\"\n";
  EXPECT_THAT(first_column(text, "1,2", spectral), Pointwise(DoubleNear(1e-9), {1.0, 8.0}));
  for (const std::string scheme : {"bdf3", "multi_term_bdf2", "decoupled_multi_order"}) {
    EXPECT_THAT(first_column(text, "2", {scheme, "--steps", "512"}), Pointwise(DoubleNear(2e-3), {8.0}))
        << scheme;
  }
}

// y = t^2 solves D^1.6 y + y D^q y = f with q a parameter; z' = D^0.5 y with y'' = 2 is z = 2
// t^2.5/Gamma(3.5).
TEST(VariableCoefficient, MayBeAnUnknownOrThatOfAnotherUnknown) {
  const std::string y =
      "end = 2\n[parameters]\nq = 0.3\n[unknown.y]\norder = 1.6\ninitial = [0, 0]\n"
      "rhs = \"2/gamma(1.4)*t^0.4 + 2/gamma(3 - q)*t^(4 - q) - y*D(y, q)\"\n";
  EXPECT_THAT(first_column(y, "1.5,2", spectral), Pointwise(DoubleNear(1e-8), {2.25, 4.0}));
  const std::string z =
      "end = 1\n[unknown.z]\norder = 1\nrhs = \"D(y, 0.5)\"\ninitial = [0]\n"
      "[unknown.y]\norder = 2\nrhs = \"2\"\ninitial = [0, 0]\n";
  EXPECT_THAT(first_column(z, "1", spectral), Pointwise(DoubleNear(1e-9), {0.60180222245094}));
}

// A derivative that a parameter 0 multiplies adds no row.
TEST(VariableCoefficient, ThatIsAbsentAddsNoColumn) {
  const TemporaryFolder folder;
  folder.write(
      "f.toml",
      "end = 1\n[parameters]\nk = 0\n[unknown.y]\norder = 1\nrhs = \"k*D(y, 0.5) - y\"\ninitial = [1]\n");
  const std::string file = folder.file("f.toml");
  EXPECT_THAT(fdebench({"exact", file, "--at", "1"}).out, StartsWith("t,y,bound\n"));
  EXPECT_THAT(fdebench({"exact", file + ":k=1", "--at", "1"}).out, StartsWith("t,y,\"D(y,0.5)\",bound\n"));
}

}  // namespace
}  // namespace fde::bench
