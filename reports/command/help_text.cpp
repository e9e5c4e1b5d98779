// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/help_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include "fdebench/reports/command/command.hpp"

// The symbols of assets.S for each topic: its first byte, and one past its last.
#define FDE_TOPIC(id, name) extern "C" const char fde_asset_topic_##id[], fde_asset_topic_##id##_end[];
#include "fdebench/reports/command/topics.def"
#undef FDE_TOPIC

namespace fde::bench {
namespace {

constexpr int name_width = 22;

std::string heading(std::string_view text, const Style& style) {
  return fmt::format("\n{}\n", in_colour(text, Colour::bold, style.colours));
}

std::string item(std::string_view name, std::string_view description, const Style& style) {
  return wrapped_item(name, description, name_width, style.columns, style.colours);
}

std::string item(const ArgumentText& argument, const Style& style) {
  const auto name = argument.is_positional() ? argument.value
                    : argument.value.empty() ? display_name(argument)
                                             : argument.name + " " + argument.value;
  return item(name, full_description(argument), style);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string examples_text(const SubcommandText& subcommand, const Style& style) {
  std::string text;
  for (const auto& [command, what] : subcommand.examples) {
    text += fmt::format("  {}\n{}", in_colour(command, Colour::green, style.colours),
                        wrapped(what, style.columns, 6));
  }
  return text;
}

Topic topic_of(std::string_view name, std::string_view file) {
  const auto end = file.find('\n');
  return {name, file.substr(0, end), file.substr(file.find_first_not_of('\n', end))};
}

}  // namespace

std::span<const Topic> topics() {
  static const std::array all{
#define FDE_TOPIC(id, name) topic_of(name, {fde_asset_topic_##id, fde_asset_topic_##id##_end}),
#include "fdebench/reports/command/topics.def"
#undef FDE_TOPIC
  };
  return all;
}

Style output_style(const Streams& streams) {
  constexpr int fewest = 40;
  if (streams.out_columns == 0) return {};
  return {.columns = std::max(fewest, streams.out_columns), .colours = streams.colours};
}

std::string overview_text(const ProgramText& program, const Style& style) {
  std::string text = wrapped(program.what + ".", style.columns);
  text += fmt::format("\nUsage: {} [-q] COMMAND ...   or {} --version\n", program.name, program.name);
  std::vector<std::string> groups;
  for (const auto& subcommand : program.subcommands) {
    if (std::ranges::find(groups, subcommand.group) == groups.end()) groups.push_back(subcommand.group);
  }
  for (const auto& group : groups) {
    text += heading(group + ":", style);
    for (const auto& subcommand : program.subcommands)
      if (subcommand.group == group) text += item(subcommand.name, subcommand.what, style);
  }
  text += heading("Topics:", style);
  for (const auto& topic : topics()) text += item(topic.name, topic.what, style);
  text += heading("Options of all commands:", style);
  for (const auto& option : common_options()) text += item(option, style);
  return text + fmt::format("\n{0} help COMMAND or {0} help TOPIC says more.\n", program.name);
}

std::string help_text(const ProgramText& program, const SubcommandText& subcommand, const Style& style) {
  constexpr int margin = 2;
  std::string text = in_colour("Usage:", Colour::bold, style.colours) + '\n';
  for (const auto& line : lines_of(synopsis(program.name, subcommand, style.columns - margin)))
    text += fmt::format("{:{}}{}\n", "", margin, line);
  text += '\n';
  text += wrapped(subcommand.what + '.', style.columns);
  const auto list = [&](std::string_view title, bool positional) {
    std::string items;
    for (const auto& argument : subcommand.arguments)
      if (argument.is_positional() == positional) items += item(argument, style);
    if (!positional)
      for (const auto& option : common_options()) items += item(option, style);
    return items.empty() ? items : heading(title, style) + items;
  };
  text += list("Arguments:", true);
  text += list("Options:", false);
  text += heading("Examples:", style);
  text += examples_text(subcommand, style);
  text += '\n';
  text += wrapped(fmt::format("Exit codes: {}.", exit_codes_text()), style.columns);
  if (!subcommand.see_also.empty()) {
    const auto separator = fmt::format(", {} help ", program.name);
    text += '\n';
    text +=
        wrapped(fmt::format("See also: {} help {}.", program.name, fmt::join(subcommand.see_also, separator)),
                style.columns);
  }
  return text;
}

std::string topic_text(const Topic& topic, const Style& style) {
  return fmt::format("{}\n\n{}", in_colour(topic.what, Colour::bold, style.colours),
                     wrapped(topic.text, style.columns));
}

}  // namespace fde::bench
