// SPDX-License-Identifier: MIT
// Help, manual pages and completions are made from the texts of the arguments; these agree with what the
// commands do.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/help_text.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

std::string file_text(const std::string& name) {
  return content_of(std::string(FDE_SOURCE_DIR) + "/" + name);
}

std::vector<std::string> lines_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// A command that is valid but for what a test adds; it has no options that exclude `argument`.
std::string command_with(const std::string& subcommand, const std::string& argument) {
  static const std::map<std::string, std::string> starts{
      {"solve", "solve relaxation --scheme l1"},
      {"exact", "exact relaxation"},
      {"choose", "choose relaxation"},
      {"run", "run --dry-run --scene relaxation --scheme l1"},
      {"stability", "stability"},
      {"geometry", "geometry loxodrome"},
      {"poles", "poles relaxation"},
      {"response", "response fractional_control"},
      {"judge", "judge relaxation /dev/null"},
      {"fit", "fit relaxation /dev/null"},
      {"compare", "compare /dev/null /dev/null"},
      {"export", "export /dev/null --out /nonexistent"},
      {"reference", "reference --check /nonexistent"},
      {"report", "report /dev/null --out /nonexistent"},
      {"study", "study plan /nonexistent.toml"},
      {"plot", "plot relaxation --out /nonexistent.svg"}};
  static const std::map<std::string, std::string> needed{
      {"solve", "--steps 8"},       {"exact", "--at 1"},     {"choose", "--error 1e-3"},
      {"stability", "--gamma 0.5"}, {"fit", "--vary gamma"}, {"plot", "--kind rate"}};
  auto text = starts.at(subcommand);
  const auto more = needed.find(subcommand);
  const bool replaces =
      more == needed.end() || more->second.starts_with(argument) || argument == "--accuracy";
  if (!replaces) text += " " + more->second;
  if (argument == "--checkpoint-every") text += " --checkpoint /nonexistent/state";
  return text;
}

// Values outside what is allowed.
std::vector<std::string> values_outside(const Allowed& allowed) {
  std::vector<std::string> values{"?"};
  if (const auto* range = std::get_if<Range>(&allowed)) {
    constexpr double tenth = 0.1;
    if (range->low > any_number.low)
      values.push_back(fmt::format("{}", range->open_low ? range->low : range->low - tenth));
    if (range->high < any_number.high)
      values.push_back(fmt::format("{}", range->open_high ? range->high : range->high * 2));
  } else if (const auto* counts = std::get_if<CountRange>(&allowed)) {
    values.push_back(fmt::format("{}", counts->lowest - 1));
    values.push_back(fmt::format("{}", std::int64_t{counts->highest} + 1));
  }
  return values;
}

// Every option and argument with a range or a choice refuses other values, with the words of the help.
TEST(HelpTexts, SayWhichValuesAreAllowed) {
  int checked = 0;
  const auto program = program_text();
  for (const auto& subcommand : program.subcommands) {
    for (const auto& argument : subcommand.arguments) {
      const auto allowed = allowed_text(argument.allowed);
      if (allowed.empty() || argument.is_positional()) continue;
      for (const auto& value : values_outside(argument.allowed)) {
        if (subcommand.name == "mittag-leffler") continue;
        const auto command =
            fmt::format("{} {}={}", command_with(subcommand.name, argument.name), argument.name, value);
        EXPECT_THAT(fdebench(command), fails_with(2, AllOf(HasSubstr(argument.name.substr(2) + " = "),
                                                           HasSubstr("must be " + allowed))))
            << command;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 60);
}

TEST(HelpTexts, SayWhichArgumentsOfMittagLefflerAreAllowed) {
  const auto program = program_text();
  for (const auto& argument : program.find("mittag-leffler")->arguments) {
    const auto allowed = allowed_text(argument.allowed);
    for (const auto& value : values_outside(argument.allowed)) {
      if (allowed.empty()) continue;
      const auto first = argument.name == "ALPHA" ? value : "0.5",
                 second = argument.name == "BETA" ? value : "1";
      const auto option = argument.is_positional() ? "" : fmt::format(" {}={}", argument.name, value);
      const auto answer = fdebench(fmt::format("mittag-leffler {} {} -1{}", first, second, option));
      EXPECT_THAT(answer.err,
                  AllOf(StartsWith("fdebench: " + argument.name), HasSubstr("must be " + allowed)));
    }
  }
}

// With a default the answer is that of the command without the option.
TEST(HelpTexts, SayTheDefaults) {
  const auto program = program_text();
  for (const std::string name : {"--grid", "--history", "--budget", "--threads"}) {
    const auto& arguments = program.find("solve")->arguments;
    const auto& usual = std::ranges::find(arguments, name, &ArgumentText::name)->usual;
    const auto command = command_with("solve", name);
    EXPECT_EQ(printed(fdebench(fmt::format("{} {} {}", command, name, usual))), fdebench(command).out)
        << name;
  }
}

TEST(HelpTexts, HaveAGroupExamplesAndRelatedCommands) {
  const auto program = program_text();
  for (const auto& subcommand : program.subcommands) {
    EXPECT_FALSE(subcommand.group.empty()) << subcommand.name;
    EXPECT_GE(subcommand.examples.size(), 2U) << subcommand.name;
    for (const auto& [command, what] : subcommand.examples) EXPECT_THAT(command, HasSubstr("fdebench "));
    EXPECT_FALSE(subcommand.see_also.empty()) << subcommand.name;
    for (const auto& name : subcommand.see_also) EXPECT_EQ(fdebench("help " + name).code, 0) << name;
  }
}

TEST(Help, OfACommandAndAnOptionAreTheSame) {
  const auto program = program_text();
  for (const auto& subcommand : program.subcommands) {
    const auto text = printed(fdebench("help " + subcommand.name));
    EXPECT_EQ(text, fdebench(subcommand.name + " --help").out);
    EXPECT_EQ(text, fdebench(subcommand.name + " -h").out);
    EXPECT_THAT(text, AllOf(StartsWith("Usage:\n  fdebench " + subcommand.name), HasSubstr("\nExamples:\n"),
                            HasSubstr("\nExit codes: "), HasSubstr("\nSee also: ")));
    for (const auto& argument : subcommand.arguments)
      EXPECT_THAT(text, HasSubstr("\n  " + (argument.is_positional() ? argument.value : argument.name)));
    for (const auto& line : lines_in(text)) {
      const bool is_command = line.starts_with("  fdebench ") || line.starts_with("  source ");
      EXPECT_LE(is_command ? 0 : line.size(), 80U) << line;
    }
  }
}

TEST(Help, ListsCommandsAndTopics) {
  const auto text = fdebench("help").out;
  EXPECT_EQ(text, fdebench("--help").out);
  const auto program = program_text();
  for (const auto& subcommand : program.subcommands)
    EXPECT_THAT(text, HasSubstr("\n  " + subcommand.name + " "));
  for (const auto& topic : topics()) EXPECT_THAT(text, HasSubstr(fmt::format("\n  {} ", topic.name)));
}

TEST(Help, HasTopics) {
  for (const auto& topic : topics()) {
    const auto text = fdebench(fmt::format("help {}", topic.name)).out;
    EXPECT_THAT(text, StartsWith(std::string(topic.what)));
    for (const auto& line : lines_in(text)) EXPECT_LE(line.size(), 80U) << line;
  }
  EXPECT_EQ(fdebench("help acuracy").err,
            "fdebench: help acuracy: no such command or topic, did you mean 'accuracy'?; fdebench help lists "
            "them\n");
  EXPECT_EQ(fdebench("help acuracy").code, 2);
}

// The widths of terminals are kept, and colours appear on a terminal only.
TEST(Help, IsAsWideAsTheTerminalAndHasColoursThere) {
  const auto printed = [](int columns, bool colours) {
    std::ostringstream out, err;
    run_fdebench({"help", "solve"}, {.out = out, .err = err, .out_columns = columns, .colours = colours});
    return out.str();
  };
  const auto widest = [](const std::string& text) {
    std::size_t most = 0;
    for (const auto& line : lines_in(text))
      if (!line.starts_with("  fdebench solve relax")) most = std::max(most, line.size());
    return most;
  };
  EXPECT_LE(widest(printed(60, false)), 60U);
  EXPECT_GT(widest(printed(120, false)), 100U);
  EXPECT_THAT(printed(80, true), HasSubstr("\x1b[1mOptions:\x1b[0m"));
  EXPECT_THAT(printed(80, false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(printed(0, true), Not(HasSubstr("\x1b"))) << "a pipe";
}

TEST(Errors, AreColouredOnATerminalOnly) {
  const auto said = [](int columns, bool colours) {
    std::ostringstream out, err;
    run_fdebench({"solv"}, {.out = out, .err = err, .columns = columns, .colours = colours});
    return err.str();
  };
  EXPECT_THAT(said(80, true), StartsWith("\x1b[1;31mfdebench:\x1b[0m command solv: no such command"));
  EXPECT_THAT(said(80, false), StartsWith("fdebench: command solv"));
  EXPECT_THAT(said(0, true), StartsWith("fdebench: command solv"));
}

struct Misuse {
  const char *words, *message;
};
class Misuses : public testing::TestWithParam<Misuse> {};

TEST_P(Misuses, AreExplainedInOneLine) {
  EXPECT_THAT(fdebench(GetParam().words),
              is_refused(2, std::string("fdebench: ") + GetParam().message + "\n"));
}

INSTANTIATE_TEST_SUITE_P(
    , Misuses,
    testing::Values(
        Misuse{"", "A subcommand is required; fdebench help lists the subcommands"},
        Misuse{"--fast", "--fast: no such option; fdebench help lists the subcommands"},
        Misuse{"solve pendulum --shceme l1 --steps 8",
               "--shceme: solve has no such option, did you mean '--scheme'?; see fdebench solve --help"},
        Misuse{"solve pendulum --steps 8",
               "--scheme is required: ID, id of the scheme; see fdebench solve --help"},
        Misuse{"solve pendulum l1 --scheme l1 --steps 8",
               "l1: solve takes no such argument; see fdebench solve --help"},
        Misuse{"solve pendulum --scheme l1 --steps",
               "--steps: its value is missing: N, number of steps over a grid; a whole number from 1 to "
               "1000000000; see fdebench solve --help"},
        Misuse{"solve pendulum --scheme l1 --steps 8 --steps 9",
               "--steps: must be given once; see fdebench solve --help"},
        Misuse{"reference", "one of --out and --check is required; see fdebench reference --help"},
        Misuse{"completion tcsh", "shell = tcsh: must be bash, zsh or fish"}),
    [](const auto& test) { return "misuse_" + std::to_string(test.index); });

// --quiet before or after the command leaves out notes, and neither results nor what an option asks for.
TEST(Quiet, LeavesOutNotesOnly) {
  const TemporaryFolder folder;
  folder.write("falling.toml", file_text("docs/examples/falling.toml"));
  const std::string solve = "solve " + folder.file("falling.toml") +
                            " --scheme spectral_collocation --accuracy 1e-6 --points 3 --cost";
  const auto loud = fdebench(solve);
  EXPECT_THAT(loud.err, StartsWith("fdebench: event "));
  for (const auto& words : {"--quiet " + solve, "-q " + solve, solve + " --quiet", solve + " -q"}) {
    const auto quiet = fdebench(words);
    EXPECT_EQ(quiet.code, 0) << quiet.err;
    EXPECT_EQ(quiet.out, loud.out);
    EXPECT_THAT(quiet.err, StartsWith("{")) << "the cost";
  }
  EXPECT_THAT(fdebench("-q solve pendulum --scheme l1 --steps 4").err, HasSubstr("warning: "));
  EXPECT_THAT(fdebench("solv -q").err, HasSubstr("no such command"));
}

// Every variable that the sources read is in the topic `environment`.
TEST(Environment, IsExplained) {
  const auto text = fdebench("help environment").out;
  for (const std::string name :
       {"benchmarks/references/cache.cpp", "benchmarks/equation_files/equation_scene.cpp",
        "benchmarks/records/session.cpp", "reports/command/main.cpp"}) {
    const auto source = file_text(name);
    for (const std::string call : {"getenv(\"", "variable(\""}) {
      for (auto at = source.find(call); at != std::string::npos; at = source.find(call, at + 1)) {
        const auto begin = at + call.size();
        EXPECT_THAT(text, HasSubstr("\n  " + source.substr(begin, source.find('"', begin) - begin) + " "));
      }
    }
  }
}

TEST(ManualPages, HaveTheSectionsOfAPage) {
  const auto program = program_text();
  for (const auto& subcommand : program.subcommands) {
    const auto page = fdebench("help --man " + subcommand.name).out;
    for (const std::string section :
         {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"})
      EXPECT_THAT(page, HasSubstr("\n.SH " + section + "\n")) << subcommand.name;
  }
  const auto page = fdebench("help --man").out;
  for (const auto& topic : topics()) {
    std::string title(topic.name);
    std::ranges::transform(title, title.begin(), [](unsigned char c) { return std::toupper(c); });
    if (const auto dash = title.find('-'); dash != std::string::npos) title.insert(dash, 1, '\\');
    EXPECT_THAT(page, HasSubstr("\n.SH " + title + "\n"));
  }
  EXPECT_EQ(fdebench("help --man nothing").code, 2);
}

}  // namespace
}  // namespace fde::bench
