// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/help_text.hpp"

namespace fde::bench {
namespace {

const SubcommandText& subcommand_named(const ProgramText& program, const std::string& name) {
  if (const auto* found = program.find(name)) return *found;
  if (std::ranges::find(topics(), name, &Topic::name) != topics().end()) {
    throw std::invalid_argument(fmt::format("help --man {}: a topic has no manual page; {} help {} prints it",
                                            name, program.name, name));
  }
  throw std::invalid_argument(fmt::format("help {}: no such command{}; {} help lists them", name,
                                          did_you_mean(name, program.names()), program.name));
}

// The text of a subcommand or of a topic.
std::string text_named(const ProgramText& program, const std::string& name, const Style& style) {
  if (const auto* found = program.find(name)) return help_text(program, *found, style);
  std::vector<std::string_view> names;
  for (const auto& topic : topics()) {
    if (topic.name == name) return topic_text(topic, style);
    names.push_back(topic.name);
  }
  const auto commands = program.names();
  names.insert(names.end(), commands.begin(), commands.end());
  throw std::invalid_argument(fmt::format("help {}: no such command or topic{}; {} help lists them", name,
                                          did_you_mean(name, names), program.name));
}

void print_help(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const auto program = program_text();
  const auto topic = given.find("topic");
  if (given.has("--man")) {
    streams.out << (topic ? man_page(program, subcommand_named(program, *topic)) : man_page(program));
  } else {
    streams.out << (topic ? text_named(program, *topic, output_style(streams))
                          : overview_text(program, output_style(streams)));
  }
}

void print_script(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  streams.out << completion_script(program_text().name, given.word("shell"));
}

}  // namespace

Command help_command() {
  return {{"help",
           "Help",
           "Explain a command or a topic, or list them",
           {{"[TOPIC]", "a command, or a topic that help lists", Completion::topic},
            {"[--man]", "print the manual page, of the program or of a command, as troff"}},
           {{"fdebench help accuracy", "explains norms and scales of errors."},
            {"fdebench help --man solve > fdebench-solve.1", "writes a manual page."}},
           {"completion"}},
          print_help};
}

Command completion_command() {
  return {{"completion",
           "Help",
           "Print the script with which a shell completes this command",
           {{"SHELL", "the shell", completion_shells()}},
           {{"source <(fdebench completion bash)", "completes commands in this shell."},
            {"fdebench completion fish > ~/.config/fish/completions/fdebench.fish",
             "does so in every fish to come."}},
           {"help"}},
          print_script};
}

}  // namespace fde::bench
