#include "command/subcommand.hpp"

#include <CLI/CLI.hpp>
#include <utility>

namespace fde {

Subcommand::Subcommand(CLI::App& app, const std::string& name, const std::string& what)
    : command_(app.add_subcommand(name, what)) {}

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

}  // namespace fde
