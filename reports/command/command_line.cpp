// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace fde::bench {

namespace {

// CLI11 parses "-1" as a number, but "-.1" as an option.
std::string with_leading_zero(const std::string& argument) {
  constexpr std::string_view digits = "0123456789";
  const bool number = argument.starts_with("-.") && argument.find_first_of(digits) == 2;
  return number ? "-0" + argument.substr(1) : argument;
}

}  // namespace

CommandLine::CommandLine(const std::string& name, const std::string& what, const std::string& version)
    : app_(std::make_unique<CLI::App>(what, name)) {
  app_->require_subcommand(1);
  app_->set_version_flag("-V,--version", version);
}

CommandLine::~CommandLine() = default;

std::vector<std::string> CommandLine::subcommands() const {
  std::vector<std::string> names;
  for (const auto* command : app_->get_subcommands({})) names.push_back(command->get_name());
  return names;
}

// CLI11 expects the arguments in reverse order.
void CommandLine::run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  try {
    std::vector<std::string> backwards;
    std::transform(arguments.rbegin(), arguments.rend(), std::back_inserter(backwards), with_leading_zero);
    app_->parse(std::move(backwards));
  } catch (const CLI::Success& help) {
    app_->exit(help, out, err);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
}

Subcommand::Subcommand(CommandLine& of, const std::string& name, const std::string& what)
    : command_(of.app_->add_subcommand(name, what)) {}

Subcommand::Option Subcommand::required(const std::string& name, std::string& value,
                                        const std::string& what) {
  return command_->add_option(name, value, what)->required();
}

Subcommand::Option Subcommand::option(const std::string& name, std::string& value, const std::string& what) {
  return command_->add_option(name, value, what);
}

Subcommand::Option Subcommand::option(const std::string& name, std::optional<std::string>& value,
                                      const std::string& what) {
  return command_->add_option(name, value, what);
}

Subcommand::Option Subcommand::list(const std::string& name, std::vector<std::string>& values,
                                    const std::string& what) {
  return command_->add_option(name, values, what)->take_all();
}

Subcommand::Option Subcommand::flag(const std::string& name, bool& value, const std::string& what) {
  return command_->add_flag(name, value, what);
}

Subcommand Subcommand::one_of() {
  auto* group = command_->add_option_group("one of");
  group->require_option(1);
  return Subcommand(*group);
}

void Subcommand::exclude(Option one, Option other) { one->excludes(other); }
void Subcommand::need(Option one, Option other) { one->needs(other); }

void Subcommand::callback(std::function<void()> action) { command_->callback(std::move(action)); }

}  // namespace fde::bench
