#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
class Option;
}  // namespace CLI

namespace fde {

// What a subcommand takes and does. It stands before CLI11, which takes ten seconds to compile in each file
// that uses it: only subcommand.cpp and command.cpp do. Values are texts; they are parsed when the subcommand
// runs. An argument's name begins with dashes, or it is taken by its place.
class Subcommand {
 public:
  using Option = CLI::Option*;

  Subcommand(CLI::App& app, const std::string& name, const std::string& what);

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
