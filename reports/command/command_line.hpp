// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/reports/command/program_text.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
class Option;
}  // namespace CLI

namespace fde::bench {

struct Streams;

// A program with subcommands. Hides CLI11, which takes ten seconds to compile: only command_line.cpp includes
// it.
class CommandLine {
 public:
  // `quiet` is set by --quiet, before or after the name of the subcommand; it must outlive run().
  CommandLine(const std::string& name, const std::string& what, const std::string& version, bool& quiet);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  CommandLine(CommandLine&&) = delete;
  CommandLine& operator=(CommandLine&&) = delete;

  [[nodiscard]] const ProgramText& text() const { return text_; }

  // Runs the subcommand selected by the arguments (after the program's name), or prints the help or the
  // version. Throws std::invalid_argument for invalid arguments before anything runs; exceptions of a
  // subcommand propagate.
  void run(const std::vector<std::string>& arguments, const Streams& streams);

 private:
  friend class Subcommand;
  std::unique_ptr<CLI::App> app_;
  bool& quiet_;
  ProgramText text_;
};

// An argument of a subcommand. Its functions add to what the help says; each returns the argument.
class Argument {
 public:
  // What stands for the value in the help, which values are allowed, and in which unit.
  Argument& takes(const std::string& value, Allowed allowed = {}, const std::string& unit = "");
  Argument& usual(const std::string& value);  // the default
  Argument& completed_by(Completion values);  // what a shell offers
  Argument& offers(Words words);              // and besides

 private:
  friend class Subcommand;
  Argument(CLI::Option* option, ArgumentText& text) : option_(option), text_(&text) {}

  CLI::Option* option_;
  ArgumentText* text_;
};

// The arguments and the action of a subcommand. Values are texts, parsed when the subcommand runs. An
// argument whose name does not begin with dashes is positional. The referenced values must outlive run().
class Subcommand {
 public:
  Subcommand(CommandLine& of, const std::string& name, const std::string& what);

  Argument required(const std::string& name, std::string& value, const std::string& what);
  Argument option(const std::string& name, std::string& value, const std::string& what);
  Argument option(const std::string& name, std::optional<std::string>& value, const std::string& what);
  // An option that may be repeated.
  Argument list(const std::string& name, std::vector<std::string>& values, const std::string& what);
  Argument flag(const std::string& name, bool& value, const std::string& what);

  // A group of options of which exactly one must be given: options added to the returned object.
  [[nodiscard]] Subcommand one_of();

  // Of the options that exclude each other one has to be given if `one_is_required`, which the action checks.
  void exclude(const Argument& one, const Argument& other, bool one_is_required = false);
  // As exclude, of arguments that the action refuses together in its own words.
  void show_as_alternatives(const Argument& one, const Argument& other, bool one_is_required = false);
  // `one` cannot be given with any of the others, which exclude nothing among themselves.
  static void replaces(const Argument& one, const std::vector<Argument>& others);
  static void need(const Argument& one, const Argument& other);  // `one` requires `other`

  // Texts of the help: the group of the subcommand in the list of all, an example, related subcommands and
  // topics.
  Subcommand& group(const std::string& name);
  Subcommand& example(const std::string& command, const std::string& what);
  Subcommand& see_also(std::vector<std::string> names);

  // The action, called after all arguments have been parsed.
  void callback(std::function<void()> action);

 private:
  Subcommand(CLI::App& command, SubcommandText& text, int choice)
      : command_(&command), text_(&text), choice_(choice) {}
  Argument added(CLI::Option* option, const std::string& name, const std::string& what);

  CLI::App* command_;
  SubcommandText* text_;
  int choice_ = 0;  // of a group of options
};

}  // namespace fde::bench
