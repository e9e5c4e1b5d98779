// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/command_line.hpp"
#include "fdebench/reports/command/completion.hpp"
#include "fdebench/reports/command/help_text.hpp"
#include "fdebench/reports/command/man_page.hpp"

namespace fde::bench {
namespace {

struct HelpArguments {
  std::optional<std::string> topic;
  bool man = false;
};

const SubcommandText& subcommand_named(const ProgramText& program, const std::string& name) {
  if (const auto* found = program.find(name)) return *found;
  if (std::ranges::find(topics(), name, &Topic::name) != topics().end()) {
    throw std::invalid_argument(fmt::format("help --man {}: a topic has no manual page; {} help {} prints it",
                                            name, program.name, name));
  }
  std::vector<std::string_view> names;
  for (const auto& subcommand : program.subcommands) names.push_back(subcommand.name);
  throw std::invalid_argument(fmt::format("help {}: no such command{}; {} help lists them", name,
                                          did_you_mean(name, names), program.name));
}

// The text of a subcommand or of a topic.
std::string text_named(const ProgramText& program, const std::string& name, const Style& style) {
  if (const auto* found = program.find(name)) return help_text(program, *found, style);
  std::vector<std::string_view> names;
  for (const auto& topic : topics()) {
    if (topic.name == name) return topic_text(topic, style);
    names.push_back(topic.name);
  }
  for (const auto& subcommand : program.subcommands) names.push_back(subcommand.name);
  throw std::invalid_argument(fmt::format("help {}: no such command or topic{}; {} help lists them", name,
                                          did_you_mean(name, names), program.name));
}

void print_help(const HelpArguments& arguments, const ProgramText& program, const Streams& streams) {
  const auto& topic = arguments.topic;
  if (arguments.man) {
    streams.out << (topic ? man_page(program, subcommand_named(program, *topic)) : man_page(program));
  } else if (topic) {
    streams.out << text_named(program, *topic, output_style(streams));
  } else {
    streams.out << overview_text(program, output_style(streams));
  }
}

}  // namespace

void add_help_commands(CommandLine& program, const Streams& streams, const SceneRegistry& /*known*/) {
  auto asked = std::make_shared<HelpArguments>();
  Subcommand help(program, "help", "Explain a command or a topic, or list them");
  help.group("Help");
  help.option("topic", asked->topic, "a command, or a topic that help lists").completed_by(Completion::topic);
  help.flag("--man", asked->man, "print the manual page, of the program or of a command, as troff");
  help.example("fdebench help accuracy", "explains norms and scales of errors.");
  help.example("fdebench help --man solve > fdebench-solve.1", "writes a manual page.");
  help.see_also({"completion"});
  help.callback([=, &program, &streams] { print_help(*asked, program.text(), streams); });

  auto shell = std::make_shared<std::string>();
  Subcommand completion(program, "completion", "Print the script with which a shell completes this command");
  completion.group("Help");
  completion.required("shell", *shell, "the shell").takes("SHELL", completion_shells());
  completion.example("source <(fdebench completion bash)", "completes commands in this shell.");
  completion.example("fdebench completion fish > ~/.config/fish/completions/fdebench.fish",
                     "does so in every fish to come.");
  completion.see_also({"help"});
  completion.callback([=, &program, &streams] {
    if (std::ranges::find(completion_shells(), *shell) == completion_shells().end())
      reject_text("shell", *shell, choice_text(completion_shells()));
    streams.out << completion_script(program.text().name, *shell);
  });
}

}  // namespace fde::bench
