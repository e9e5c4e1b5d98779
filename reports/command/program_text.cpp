// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace fde::bench {
namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

template <typename Items>
auto* named(Items& items, std::string_view name) {
  const auto found = std::ranges::find_if(items, [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

// "--steps N", "SCENE".
std::string with_value(const ArgumentText& argument) {
  if (argument.is_positional()) return argument.value;
  return argument.value.empty() ? argument.name : argument.name + " " + argument.value;
}

std::string part_of(const ArgumentText& argument) {
  const auto part = argument.required ? with_value(argument) : fmt::format("[{}]", with_value(argument));
  return argument.repeated ? part + "..." : part;
}

}  // namespace

ArgumentText::ArgumentText(std::string_view form, std::string what_for, Allowed values,
                           std::string by_default)
    : what(std::move(what_for)),
      allowed(std::move(values)),
      usual(std::move(by_default)),
      required(!form.starts_with('[')),
      repeated(form.ends_with("...") && !form.ends_with(",...")) {
  if (repeated) form.remove_suffix(3);
  const bool opens = form.starts_with('[') || form.starts_with('(');
  begins_choice = opens && form.ends_with('|');
  ends_choice = !opens && (form.ends_with(']') || form.ends_with(')'));
  form.remove_prefix(opens ? 1 : 0);
  form = form.substr(0, form.find_last_not_of(" |])") + 1);
  const bool is_option = form.starts_with('-');
  const auto end = std::min(form.find(is_option ? ' ' : ':'), form.size());
  value = form.substr(std::min(end + 1, form.size()));
  name = form.substr(0, end);
  if (is_option || !value.empty()) return;
  value = std::exchange(name, lower_case(name));
}

void set_choices(std::vector<ArgumentText>& arguments) {
  int last = 0, open = 0;
  bool is_required = false;
  for (auto& argument : arguments) {
    if (argument.begins_choice) {
      open = ++last;
      is_required = argument.required;
    }
    argument.choice = open;
    if (open != 0) argument.required = is_required;
    if (argument.ends_choice) open = 0;
  }
}

const ArgumentText* SubcommandText::find(std::string_view argument) const {
  return named(arguments, argument);
}

const SubcommandText* ProgramText::find(std::string_view subcommand) const {
  return named(subcommands, subcommand);
}

std::vector<std::string_view> ProgramText::names() const {
  std::vector<std::string_view> all;
  for (const auto& subcommand : subcommands) all.emplace_back(subcommand.name);
  return all;
}

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
  const bool is_grid = std::get<Completion>(allowed) == Completion::grid;
  return is_grid ? "uniform or graded:R with R in [1, 100], or graded:auto" : "";
}

std::string display_name(const ArgumentText& flag) {
  const auto comma = flag.name.find(',');
  return comma == std::string::npos
             ? flag.name
             : fmt::format("{}, {}", flag.name.substr(0, comma), flag.name.substr(comma + 1));
}

const std::vector<ArgumentText>& common_options() {
  static const std::vector<ArgumentText> options{
      {"[-q,--quiet]",
       "no progress and no notes on standard error; warnings, errors and what an option asks for, such as "
       "--cost, are still written"},
      {"[-h,--help]", "print this help"}};
  return options;
}

std::string exit_codes_text() {
  return "0 done; 1 compare finds the second file worse; 2 bad input, too little memory, or output that "
         "cannot be written; 3 numerical failure";
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
  if (argument.value == "SECONDS" || argument.name == "--seconds") add("in seconds");
  if (!argument.usual.empty()) add("default " + argument.usual);
  if (argument.repeated && !argument.is_positional()) add("may be repeated");
  return text;
}

}  // namespace fde::bench
