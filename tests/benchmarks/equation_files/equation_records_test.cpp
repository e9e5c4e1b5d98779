// SPDX-License-Identifier: MIT
// Scenes of equation files on the command line, in results, in recommendations and on the page.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/unpacked_page.hpp"

namespace fde::bench {
namespace {

const std::string decay =
    "title = \"Decay\"\nend = 2\n[parameters]\nk = 1\n[unknown.x]\norder = 0.5\nrhs = \"-k*x\"\ninitial = "
    "[1]\n";

class EquationFileCommand : public testing::Test {
 protected:
  void SetUp() override { folder_.write("decay.toml", decay); }
  [[nodiscard]] std::string file() const { return folder_.path() / "decay.toml"; }
  [[nodiscard]] std::string results() const { return folder_.path() / "results.jsonl"; }
  [[nodiscard]] CommandOutput run(const std::string& scene) const {
    return fdebench("run --scene " + scene + " --scheme l1 --steps 16,32 --repeat 1 --out " + results());
  }
  TemporaryFolder folder_;
};

TEST_F(EquationFileCommand, TakesSettings) {
  const auto at = [&](const std::string& scene) { return fdebench("exact " + scene + " --at 1").out; };
  EXPECT_THAT(at(file()), StartsWith("t,x,bound\n1,0.427583576155807"));
  EXPECT_EQ(at(file() + ":k=2"), at(file() + " --set k=2"));
  // E_0.5(-2) = e^4 erfc(2)
  EXPECT_THAT(at(file() + ":k=2"), StartsWith("t,x,bound\n1,0.255395676310505"));
  EXPECT_EQ(fdebench("exact " + file() + ":q=2 --at 1").err,
            "fdebench: q: scene " + file() + " has no such parameter; it has k\n");
}

TEST_F(EquationFileCommand, TakesAnEnd) {
  const auto end = [&](const std::string& words) {
    return csv_rows(fdebench("solve " + words + " --scheme l1 --steps 4").out).back().front();
  };
  EXPECT_EQ(end(file()), 2.0);
  EXPECT_EQ(end(file() + " --until 3"), 3.0);
  EXPECT_EQ(end(file() + ":k=2,until=4"), 4.0);
}

TEST_F(EquationFileCommand, IsListed) {
  const auto answer = printed(fdebench("scenes " + file()));
  EXPECT_THAT(answer, StartsWith(file() + ": Decay\n"));
  EXPECT_THAT(answer, HasSubstr("columns: x\nhas: exact, jacobian, linear\n"));
  EXPECT_THAT(answer, HasSubstr("k           1         a finite number"));
}

TEST_F(EquationFileCommand, PrintsNamesOfDerivativesInQuotes) {
  const auto answer = fdebench("solve " + example("duffing.toml") + " --scheme l1 --steps 4 --points 2");
  EXPECT_THAT(answer.out, StartsWith("t,x,\"D(x,0.5)\",\"D(x,1)\"\n0,"));
}

TEST_F(EquationFileCommand, IsJudgedByTheColumnsThatItPrints) {
  const auto solved = fdebench("solve " + example("falling.toml") + " --scheme l1 --steps 64");
  folder_.write("path.csv", solved.out);
  EXPECT_THAT(printed(fdebench("judge " + example("falling.toml") + " " + folder_.file("path.csv"))),
              HasSubstr("ending finished"));
}

TEST_F(EquationFileCommand, IsMeasuredAndContinued) {
  ASSERT_EQ(run(file()).code, 0);
  const auto once = content_of(results());
  EXPECT_THAT(once, HasSubstr("\"checksum\":\""));
  ASSERT_EQ(run(file()).code, 0);
  EXPECT_EQ(content_of(results()), once);
}

// Another equation under the same name is measured again.
TEST_F(EquationFileCommand, IsAnotherSceneWhereItSaysSomethingElse) {
  ASSERT_EQ(run(file()).code, 0);
  const auto once = content_of(results());
  folder_.write("decay.toml", "# a comment\n" + decay);
  ASSERT_EQ(run(file()).code, 0);
  EXPECT_EQ(content_of(results()), once);
  std::string other = decay;
  other.replace(other.find("-k*x"), 4, "-k*x/2");
  folder_.write("decay.toml", other);
  ASSERT_EQ(run(file()).code, 0);
  EXPECT_GT(content_of(results()).size(), once.size());
  const auto folder = folder_.file("page");
  EXPECT_EQ(fdebench("report " + results() + " --out " + folder).code, 0);
}

TEST_F(EquationFileCommand, NeedsNotBeAtHandForItsResults) {
  ASSERT_EQ(run(file()).code, 0);
  std::filesystem::remove(folder_.path() / "decay.toml");
  EXPECT_THAT(printed(fdebench("choose " + file() + " --error 0.1 --results " + results())),
              StartsWith("run: fdebench solve " + file() + " "));
  EXPECT_EQ(fdebench("choose " + file() + ":k=2 --error 0.1 --results " + results()).code, 2);
  const auto folder = folder_.file("page");
  EXPECT_EQ(fdebench("report " + results() + " --out " + folder).code, 0);
  EXPECT_THAT(unpacked(content_of(folder + "/index.html"), "data"), HasSubstr("decay.toml"));
  EXPECT_EQ(fdebench("compare " + results() + " " + results()).code, 0);
}

TEST_F(EquationFileCommand, IsNotTakenForAnotherOfItsName) {
  ASSERT_EQ(run(file()).code, 0);
  std::string other = decay;
  other.replace(other.find("-k*x"), 4, "-k*x/2");
  folder_.write("decay.toml", other);
  const std::string choose = "choose " + file() + " --error 0.1 --results " + results();
  EXPECT_EQ(fdebench(choose).code, 2);
  EXPECT_THAT(fdebench(choose).err, HasSubstr("only of another file of this name"));
  ASSERT_EQ(run(file()).code, 0);
  EXPECT_EQ(fdebench(choose).code, 0);
  std::filesystem::remove(folder_.path() / "decay.toml");
  EXPECT_THAT(fdebench(choose).err, HasSubstr("has runs of more than one file that was " + file()));
}

TEST_F(EquationFileCommand, MakesARangeOfScenes) {
  const auto answer = fdebench("run --scene " + file() + ":k=1:3:1 --scheme l1 --steps 16 --dry-run");
  EXPECT_THAT(answer.out, HasSubstr(file() + ":k=2 l1 N = 16"));
  EXPECT_THAT(answer.out, HasSubstr("3 runs"));
}

TEST_F(EquationFileCommand, LosesALineWithAChecksumThatIsNone) {
  ASSERT_EQ(run(file()).code, 0);
  const std::string key = R"("checksum":")";
  auto text = content_of(results());
  const auto at = text.find(key) + key.size();
  text[at] = 'Z';
  folder_.write("changed.jsonl", text);
  const auto answer = fdebench("report " + folder_.file("changed.jsonl") + " --out " + folder_.file("page"));
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.err, HasSubstr("must be a SHA-256 in hexadecimal"));
}

}  // namespace
}  // namespace fde::bench
