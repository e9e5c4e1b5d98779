// What fuzzing found, each with its message: tests/fuzz has the programs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "answer_of.hpp"
#include "description.hpp"
#include "reference_check.hpp"
#include "temporary_folder.hpp"
#include "testing.hpp"

namespace fde {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(HostileInput, ControlCharactersDoNotReachTheTerminal) {
  const auto answer = fdebench({"report", "a\x1b[2J\r\x7f", "--out", "x"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.err, "fdebench: a\\x1b[2J\\x0d\\x7f: cannot be read: No such file or directory\n");
}

TEST(HostileInput, ANameThatIsTooLongIsNamed) {
  const std::string name(5000, 'a');
  EXPECT_EQ(fdebench({"report", name, "--out", "x"}).err,
            "fdebench: " + name + ": cannot be read: File name too long\n");
  EXPECT_EQ(fdebench({"run", "--scene", "power", "--scheme", "l1", "--steps", "8", "--out", name}).err,
            "fdebench: " + name + ": cannot be written: File name too long\n");
}

TEST(HostileInput, ANumberMayBeginWithMinusAndPoint) {
  EXPECT_EQ(fdebench({"mittag-leffler", "0.5", "1", "-.5"}).out,
            fdebench({"mittag-leffler", "0.5", "1", "-0.5"}).out);
  EXPECT_EQ(fdebench({"mittag-leffler", "0.5", "-.5", "1"}).code, 0);
  EXPECT_EQ(fdebench({"mittag-leffler", "0.5", "1", "-.x"}).code, 2);
}

TEST(HostileInput, TimesBeyondDoubleAreRefused) {
  const auto until = [](const std::string& end) {
    return fdebench({"solve", "relaxation", "--scheme", "l1", "--steps", "8", "--until", end});
  };
  EXPECT_EQ(until("1e308").err, "fdebench: --until = 1e+308: must be a number in (0, 1e+290]\n");
  EXPECT_THAT(until("2.2e307").out, testing::Not(HasSubstr("inf")));
}

TEST(HostileInput, FunctionsBeyondDoubleAreAFailure) {
  for (const auto& words : {std::vector<std::string>{"1", "1", "1000"},
                            {"4.999", "5.3e-315", "-1.07e270,3.2e-322"},
                            {"1", "1", "--matrix", "1,2;3,4000"}}) {
    std::vector<std::string> arguments{"mittag-leffler"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const auto [code, out, err] = fdebench(arguments);
    EXPECT_EQ(code, 3);
    EXPECT_EQ(out, "");
  }
}

TEST(HostileInput, AnEmptyArgumentIsNamed) {
  EXPECT_EQ(fdebench({"reference", "", "--every", "2"}).err, "fdebench: argument 2 is empty\n");
  EXPECT_EQ(fdebench({"exact", "", "--at", "1"}).err, "fdebench: argument 2 is empty\n");
  EXPECT_EQ(fdebench({""}).err, "fdebench: argument 1 is empty\n");
}

// Such an order rounds to 0/M, a chain without links.
TEST(HostileInput, AnOrderNextToZeroIsNoMultipleOfOneOverM) {
  const Scene scene = scene_of("pendulum", {{"alpha", 1.0}, {"beta", 5e-324}});
  const auto reason = refusal(*find_scheme("commensurate_adams_pc"), scene.problem, {.end = 1.0, .steps = 8});
  EXPECT_EQ(reason, "needs orders that are multiples of one 1/M with M at most 64");
}

// To open a pipe for reading would wait for somebody to write.
TEST(HostileInput, PipesAreNotRead) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "a.csv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT([&] { check_folder(folder.path(), 1, [](std::size_t, std::size_t, const std::string&) {}); },
              ThrowsMessage<std::invalid_argument>(pipe.string() + ": cannot be read: is not a file"));
  EXPECT_EQ(fdebench({"report", pipe.string(), "--out", "x"}).code, 2);
}

TEST(HostileInput, DescriptionsOfOtherTypesAreRefusedInOurWords) {
  EXPECT_THAT([] { parse_description("a.json", R"({"schema": {"version": "x"}})"); },
              ThrowsMessage<std::invalid_argument>(
                  "a.json: is not as docs/reference_data.md says: type must be number, but is string"));
}

}  // namespace
}  // namespace fde
