#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
class Option;
}  // namespace CLI

namespace fde {

// A program with subcommands. It stands before CLI11, which takes ten seconds to compile in each file that
// uses it: only command_line.cpp does.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& what, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  CommandLine(CommandLine&&) = delete;
  CommandLine& operator=(CommandLine&&) = delete;

  [[nodiscard]] std::vector<std::string> subcommands() const;  // their names

  // Runs the subcommand that these arguments, after the program's name, ask for, or prints the help or the
  // version. Throws std::invalid_argument, before it runs anything, for arguments that no subcommand takes;
  // what a subcommand throws is passed on.
  void run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

 private:
  friend class Subcommand;
  std::unique_ptr<CLI::App> app_;
};

// What a subcommand takes and does. Values are texts; they are parsed when the subcommand runs. An argument's
// name begins with dashes, or it is taken by its place.
class Subcommand {
 public:
  using Option = CLI::Option*;

  Subcommand(CommandLine& of, const std::string& name, const std::string& what);

  Option required(const std::string& name, std::string& value, const std::string& what);
  Option option(const std::string& name, std::string& value, const std::string& what);
  Option option(const std::string& name, std::optional<std::string>& value, const std::string& what);
  // May be given again.
  Option list(const std::string& name, std::vector<std::string>& values, const std::string& what);
  Option flag(const std::string& name, bool& value, const std::string& what);

  // Exactly one of the options that are added to what this returns must be given.
  [[nodiscard]] Subcommand one_of();

  static void exclude(Option one, Option other);
  static void need(Option one, Option other);  // one is only taken with the other

  // Called after all arguments have been taken.
  void callback(std::function<void()> action);

 private:
  explicit Subcommand(CLI::App& command) : command_(&command) {}

  CLI::App* command_;
};

}  // namespace fde
