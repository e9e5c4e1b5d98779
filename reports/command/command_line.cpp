// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/help_text.hpp"

namespace fde::bench {

namespace {

// CLI11 parses "-1" as a number, but "-.1" as an option.
std::string with_leading_zero(const std::string& argument) {
  constexpr std::string_view digits = "0123456789";
  const bool number = argument.starts_with("-.") && argument.find_first_of(digits) == 2;
  return number ? "-0" + argument.substr(1) : argument;
}

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

const ArgumentText* named(const SubcommandText& subcommand, std::string_view name) {
  const auto found = std::ranges::find(subcommand.arguments, name, &ArgumentText::name);
  return found == subcommand.arguments.end() ? nullptr : &*found;
}

// A number that no group of exclusive arguments has.
int next_choice(const SubcommandText& subcommand) {
  int last = 0;
  for (const auto& argument : subcommand.arguments) last = std::max(last, argument.choice);
  return last + 1;
}

// The first word that looks like an option and is none of the subcommand.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& arguments) {
  for (const auto& word : arguments) {
    auto name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || name == "--") continue;
    if (command.get_option_no_throw(name) == nullptr) return name;
  }
  return {};
}

// What other programs call our options.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> foreign_options{
    {{"--h", "--steps"},        {"--dt", "--steps"},       {"--step", "--steps"},    {"--n", "--steps"},
     {"--N", "--steps"},        {"--rtol", "--accuracy"},  {"--atol", "--accuracy"}, {"--tol", "--accuracy"},
     {"--accuracy", "--error"}, {"--error", "--accuracy"}, {"--tspan", "--until"},   {"--t_end", "--until"},
     {"--end", "--until"},      {"--T", "--until"},        {"--method", "--scheme"}, {"--solver", "--scheme"},
     {"--output", "--out"},     {"--times", "--at"},       {"--parameter", "--set"}, {"--param", "--set"}}};

std::string suggestion(const SubcommandText& subcommand, std::string_view name) {
  for (const auto& [foreign, own] : foreign_options)
    if (name == foreign && named(subcommand, own) != nullptr) return fmt::format("; here it is {}", own);
  std::vector<std::string_view> options{"--quiet", "--help"};
  for (const auto& argument : subcommand.arguments)
    if (!argument.is_positional()) options.emplace_back(argument.name);
  const auto meant = did_you_mean(name, options);
  const bool has_parameters = meant.empty() && named(subcommand, "--set") != nullptr;
  return has_parameters ? "; a parameter of the scene is set by --set NAME=VALUE" : meant;
}

// "--scheme is required: ID, the id of the scheme".
std::string missing_argument(const SubcommandText& subcommand, const std::string& said) {
  const auto name = said.substr(0, said.find(' '));
  if (const auto* argument = named(subcommand, name))
    return fmt::format("{}: {}, {}", said, argument->value, full_description(*argument));
  std::string all;
  for (const auto& argument : subcommand.arguments) {
    if (argument.choice != 0 && argument.required) all += (all.empty() ? "" : " and ") + argument.name;
  }
  return all.empty() ? said : fmt::format("one of {} is required", all);
}

// An option without its value or given twice, or a flag with a value.
std::string wrong_count(const SubcommandText& subcommand, const std::vector<std::string>& arguments,
                        const std::string& said) {
  const auto name = said.substr(0, said.find(':'));
  const auto* const argument = named(subcommand, name);
  if (argument == nullptr) return said;
  if (argument->value.empty()) return fmt::format("{}: takes no value", name);
  const auto times = std::ranges::count_if(
      arguments, [&](const std::string& word) { return word == name || word.starts_with(name + "="); });
  if (times > 1 && !argument->repeated) return fmt::format("{}: must be given once", name);
  return fmt::format("{}: its value is missing: {}, {}", name, argument->value, full_description(*argument));
}

// CLI11 takes --quiet=1 and --quiet=false; of our options those without a value take none.
void require_flags_alone(const ProgramText& program, const std::vector<std::string>& arguments) {
  const auto first = std::ranges::find_if(arguments, [&](const auto& word) { return program.find(word); });
  if (first == arguments.end()) return;
  const auto& subcommand = *program.find(*first);
  for (const auto& word : arguments) {
    if (word == "--") return;
    if (!word.starts_with("--") || word.find('=') == std::string::npos) continue;
    const auto name = word.substr(0, word.find('='));
    const auto is_flag = [&](const ArgumentText& of) {
      return of.value.empty() && (of.name == name || of.name.ends_with("," + name));
    };
    if (std::ranges::any_of(common_options(), is_flag) ||
        std::ranges::any_of(subcommand.arguments, is_flag)) {
      throw std::invalid_argument(
          fmt::format("{}: takes no value; see {} {} --help", name, program.name, subcommand.name));
    }
  }
}

// What is wrong with the arguments of a subcommand, in our words.
std::string mistake(const CLI::ParseError& error, const CLI::App& command, const SubcommandText& subcommand,
                    const std::vector<std::string>& arguments) {
  if (const auto option = unknown_option(command, arguments); !option.empty()) {
    return fmt::format("{}: {} has no such option{}", option, subcommand.name,
                       suggestion(subcommand, option));
  }
  std::string said = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const auto rest = command.remaining(true);
    const std::string word = rest.empty() ? said : rest.front();
    const bool is_setting = word.find('=') != std::string::npos && named(subcommand, "--set") != nullptr;
    return fmt::format("{}: {} takes no such argument{}", word, subcommand.name,
                       is_setting ? fmt::format("; --set {} sets a parameter", word) : "");
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing_argument(subcommand, said);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr ||
      dynamic_cast<const CLI::ConversionError*>(&error) != nullptr)
    return wrong_count(subcommand, arguments, said);
  return said;
}

}  // namespace

CommandLine::CommandLine(const std::string& name, const std::string& what, const std::string& version,
                         bool& quiet)
    : app_(std::make_unique<CLI::App>(what, name)),
      quiet_(quiet),
      text_{.name = name, .what = what, .version = version} {
  app_->require_subcommand(1);
  app_->set_version_flag("-V,--version", version);
  app_->add_flag(common_options().front().name, quiet);
}

CommandLine::~CommandLine() = default;

// CLI11 expects the arguments in reverse order.
void CommandLine::run(const std::vector<std::string>& arguments, const Streams& streams) {
  require_flags_alone(text_, arguments);
  const auto selected = [&] {
    const auto commands = app_->get_subcommands();
    return commands.empty() ? nullptr : commands.front();
  };
  try {
    std::vector<std::string> backwards;
    std::transform(arguments.rbegin(), arguments.rend(), std::back_inserter(backwards), with_leading_zero);
    app_->parse(std::move(backwards));
  } catch (const CLI::CallForHelp&) {
    const auto* const command = selected();
    streams.out << (command == nullptr
                        ? overview_text(text_, output_style(streams))
                        : help_text(text_, *text_.find(command->get_name()), output_style(streams)));
  } catch (const CLI::Success& version) {
    app_->exit(version, streams.out, streams.err);
  } catch (const CLI::ParseError& error) {
    const auto* const command = selected();
    if (command == nullptr) {
      const auto unknown = unknown_option(*app_, arguments);
      throw std::invalid_argument(fmt::format(
          "{}; {} help lists the subcommands",
          unknown.empty() ? std::string(error.what()) : unknown + ": no such option", text_.name));
    }
    const auto& subcommand = *text_.find(command->get_name());
    throw std::invalid_argument(fmt::format("{}; see {} {} --help",
                                            mistake(error, *command, subcommand, arguments), text_.name,
                                            subcommand.name));
  }
}

Argument& Argument::takes(const std::string& value, Allowed allowed, const std::string& unit) {
  text_->value = value;
  text_->allowed = std::move(allowed);
  text_->unit = unit;
  return *this;
}

Argument& Argument::usual(const std::string& value) {
  text_->usual = value;
  return *this;
}

Argument& Argument::completed_by(Completion values) {
  text_->completion = values;
  return *this;
}

Argument& Argument::offers(Words words) {
  text_->offered = std::move(words);
  return *this;
}

Subcommand::Subcommand(CommandLine& of, const std::string& name, const std::string& what)
    : command_(of.app_->add_subcommand(name, what)), text_(&of.text_.subcommands.emplace_back()) {
  text_->name = name;
  text_->what = what;
  command_->add_flag(common_options().front().name, of.quiet_);
}

Argument Subcommand::added(CLI::Option* option, const std::string& name, const std::string& what) {
  auto& text = text_->arguments.emplace_back();
  text.name = name;
  text.what = what;
  text.value = upper_case(name.substr(std::min(name.find_first_not_of('-'), name.size())));
  text.choice = choice_;
  text.required = choice_ != 0;
  return {option, text};
}

Argument Subcommand::required(const std::string& name, std::string& value, const std::string& what) {
  auto argument = added(command_->add_option(name, value, what)->required(), name, what);
  argument.text_->required = true;
  return argument;
}

Argument Subcommand::option(const std::string& name, std::string& value, const std::string& what) {
  return added(command_->add_option(name, value, what), name, what);
}

Argument Subcommand::option(const std::string& name, std::optional<std::string>& value,
                            const std::string& what) {
  return added(command_->add_option(name, value, what), name, what);
}

Argument Subcommand::list(const std::string& name, std::vector<std::string>& values,
                          const std::string& what) {
  auto argument = added(command_->add_option(name, values, what)->take_all(), name, what);
  argument.text_->repeated = true;
  return argument;
}

Argument Subcommand::flag(const std::string& name, bool& value, const std::string& what) {
  auto argument = added(command_->add_flag(name, value, what), name, what);
  argument.text_->value.clear();
  return argument;
}

Subcommand Subcommand::one_of() {
  auto* group = command_->add_option_group("one of");
  group->require_option(1);
  return {*group, *text_, next_choice(*text_)};
}

void Subcommand::exclude(const Argument& one, const Argument& other, bool one_is_required) {
  one.option_->excludes(other.option_);
  show_as_alternatives(one, other, one_is_required);
}

void Subcommand::show_as_alternatives(const Argument& one, const Argument& other, bool one_is_required) {
  auto& first = *one.text_;
  auto& second = *other.text_;
  const int mine = std::max(first.choice, second.choice);
  first.choice = second.choice = mine != 0 ? mine : next_choice(*text_);
  first.required = second.required = first.required || one_is_required;
}

void Subcommand::replaces(const Argument& one, const std::vector<Argument>& others) {
  for (const auto& other : others) one.option_->excludes(other.option_);
}

void Subcommand::need(const Argument& one, const Argument& other) { one.option_->needs(other.option_); }

Subcommand& Subcommand::group(const std::string& name) {
  text_->group = name;
  return *this;
}

Subcommand& Subcommand::example(const std::string& command, const std::string& what) {
  text_->examples.emplace_back(command, what);
  return *this;
}

Subcommand& Subcommand::see_also(std::vector<std::string> names) {
  text_->see_also = std::move(names);
  return *this;
}

void Subcommand::callback(std::function<void()> action) { command_->callback(std::move(action)); }

}  // namespace fde::bench
