// SPDX-License-Identifier: MIT
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

namespace fde::bench {

// A program with subcommands. Hides CLI11, which takes ten seconds to compile: only command_line.cpp includes
// it.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& what, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  CommandLine(CommandLine&&) = delete;
  CommandLine& operator=(CommandLine&&) = delete;

  [[nodiscard]] std::vector<std::string> subcommands() const;  // their names

  // Runs the subcommand selected by the arguments (after the program's name), or prints the help or the
  // version. Throws std::invalid_argument for invalid arguments before anything runs; exceptions of a
  // subcommand propagate.
  void run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

 private:
  friend class Subcommand;
  std::unique_ptr<CLI::App> app_;
};

// The arguments and the action of a subcommand. Values are texts, parsed when the subcommand runs. An
// argument whose name does not begin with dashes is positional. The referenced values must outlive run().
class Subcommand {
 public:
  using Option = CLI::Option*;

  Subcommand(CommandLine& of, const std::string& name, const std::string& what);

  Option required(const std::string& name, std::string& value, const std::string& what);
  Option option(const std::string& name, std::string& value, const std::string& what);
  Option option(const std::string& name, std::optional<std::string>& value, const std::string& what);
  // An option that may be repeated.
  Option list(const std::string& name, std::vector<std::string>& values, const std::string& what);
  Option flag(const std::string& name, bool& value, const std::string& what);

  // A group of options of which exactly one must be given: options added to the returned object.
  [[nodiscard]] Subcommand one_of();

  static void exclude(Option one, Option other);
  static void need(Option one, Option other);  // `one` requires `other`

  // The action, called after all arguments have been parsed.
  void callback(std::function<void()> action);

 private:
  explicit Subcommand(CLI::App& command) : command_(&command) {}

  CLI::App* command_;
};

}  // namespace fde::bench
