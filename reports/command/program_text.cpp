// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace fde::bench {
namespace {

std::string value_text(const ArgumentText& argument) {
  if (argument.is_positional() || argument.value.empty()) return argument.value;
  return " " + argument.value;
}

// "--steps N", "SCENE".
std::string with_value(const ArgumentText& argument) {
  return argument.is_positional() ? argument.value : argument.name + value_text(argument);
}

std::string part_of(const ArgumentText& argument) {
  const bool needed = argument.required || (argument.repeated && argument.is_positional());
  const auto part = needed ? with_value(argument) : fmt::format("[{}]", with_value(argument));
  return argument.repeated ? part + "..." : part;
}

}  // namespace

std::string choice_text(const Words& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string allowed_text(const Allowed& allowed) {
  if (const auto* words = std::get_if<Words>(&allowed)) return choice_text(*words);
  if (const auto* numbers = std::get_if<Range>(&allowed)) return numbers->text();
  if (const auto* counts = std::get_if<CountRange>(&allowed)) return counts->text();
  if (const auto* text = std::get_if<std::string>(&allowed)) return *text;
  return {};
}

const SubcommandText* ProgramText::find(const std::string& subcommand) const {
  const auto found = std::ranges::find(subcommands, subcommand, &SubcommandText::name);
  return found == subcommands.end() ? nullptr : &*found;
}

std::string display_name(const ArgumentText& flag) {
  const auto comma = flag.name.find(',');
  return comma == std::string::npos
             ? flag.name
             : fmt::format("{}, {}", flag.name.substr(0, comma), flag.name.substr(comma + 1));
}

const std::vector<ArgumentText>& common_options() {
  static const std::vector<ArgumentText> options{
      {.name = "-q,--quiet",
       .what =
           "no progress and no notes on standard error; warnings, errors and what an option asks for, such "
           "as --cost, are still written",
       .value = ""},
      {.name = "-h,--help", .what = "print this help", .value = ""}};
  return options;
}

std::string exit_codes_text() {
  return "0 done; 1 compare finds the second file worse; 2 bad input, too little memory, or output that "
         "cannot "
         "be written; 3 numerical failure";
}

std::vector<std::string> synopsis_parts(const SubcommandText& subcommand) {
  std::vector<std::string> positional, options;
  std::set<int> shown;
  for (const auto& argument : subcommand.arguments) {
    if (argument.choice == 0) {
      (argument.is_positional() ? positional : options).push_back(part_of(argument));
    } else if (shown.insert(argument.choice).second) {
      std::string alternatives;
      for (const auto& other : subcommand.arguments) {
        if (other.choice == argument.choice)
          alternatives += (alternatives.empty() ? "" : " | ") + with_value(other);
      }
      options.push_back(argument.required ? fmt::format("({})", alternatives)
                                          : fmt::format("[{}]", alternatives));
    }
  }
  positional.insert(positional.end(), options.begin(), options.end());
  return positional;
}

std::string synopsis(const std::string& program, const SubcommandText& subcommand, int columns) {
  std::string text = fmt::format("{} {}", program, subcommand.name);
  const std::string indent(text.size(), ' ');
  std::size_t width = text.size();
  for (const auto& part : synopsis_parts(subcommand)) {
    if (width > indent.size() && width + 1 + part.size() > static_cast<std::size_t>(columns)) {
      text += "\n" + indent;
      width = indent.size();
    }
    text += " " + part;
    width += 1 + part.size();
  }
  return text;
}

std::string full_description(const ArgumentText& argument) {
  std::string text = argument.what;
  const auto add = [&](const std::string& more) {
    if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
  };
  add(allowed_text(argument.allowed));
  if (!argument.unit.empty()) add("in " + argument.unit);
  if (!argument.usual.empty()) add("default " + argument.usual);
  if (argument.repeated && !argument.is_positional()) add("may be repeated");
  return text;
}

}  // namespace fde::bench
