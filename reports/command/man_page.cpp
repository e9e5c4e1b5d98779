// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/reports/command/help_text.hpp"

namespace fde::bench {
namespace {

// Text in which troff finds no escapes and no requests.
std::string escaped(std::string_view text) {
  const auto result =
      replaced(text, {{'\\', "\\e"}, {'-', "\\-"}, {'^', "\\(ha"}, {'~', "\\(ti"}, {'\'', "\\(aq"}});
  return result.starts_with('.') ? "\\&" + result : result;
}

// A line per sentence, as troff wants text.
std::string sentences(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find(". ", begin), text.size());
    const auto sentence = text.substr(begin, end == text.size() ? end : end + 1 - begin);
    result += escaped(sentence) + "\n";
    begin = end == text.size() ? end : end + 2;
  }
  return result;
}

// A section or part of a command's name is in upper case.
std::string title(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::toupper(c); });
  return escaped(result);
}

std::string header(const ProgramText& program, const std::string& name) {
  return fmt::format(".TH {} 1 \"{}\" \"{} {}\" \"{} manual\"\n", title(name), FDEBENCH_RELEASED,
                     program.name, program.version, program.name);
}

// Options are bold, other words of a synopsis are as they are.
std::string bold_options(const std::string& part) {
  std::string result, word;
  for (const char c : part + " ") {
    const bool is_part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
    if (is_part) {
      word += c;
      continue;
    }
    result += word.starts_with('-') ? fmt::format("\\fB{}\\fR", escaped(word)) : escaped(word);
    result += c;
    word.clear();
  }
  result.pop_back();
  return result;
}

std::string tagged(const ArgumentText& argument) {
  const auto name =
      argument.is_positional() ? "" : fmt::format("\\fB{}\\fR", escaped(display_name(argument)));
  const auto* const gap = name.empty() || argument.value.empty() ? "" : " ";
  const auto value = argument.value.empty() ? "" : fmt::format("\\fI{}\\fR", escaped(argument.value));
  return fmt::format(".TP\n{}{}{}\n{}", name, gap, value, sentences(full_description(argument)));
}

// Lines that begin with blanks: the rows of a table, or as they are.
std::string indented_block(const std::vector<std::string>& lines) {
  std::string result;
  if (std::ranges::all_of(lines, [](const auto& line) { return description_of_row(line) < line.size(); })) {
    for (const auto& line : lines) {
      const auto begin = description_of_row(line);
      const auto name = line.substr(2, line.find_last_not_of(' ', begin - 1) - 1);
      result += fmt::format(".TP\n\\fB{}\\fR\n{}", escaped(name), sentences(line.substr(begin)));
    }
    return result;
  }
  for (const auto& line : lines) result += escaped(line.substr(2)) + "\n";
  return fmt::format(".PP\n.RS\n.EX\n{}.EE\n.RE\n", result);
}

// The paragraphs and blocks of a topic.
std::string paragraphs(std::string_view text) {
  std::istringstream lines{std::string(text) + "\n\n"};
  std::string result, line;
  std::vector<std::string> block;
  while (std::getline(lines, line)) {
    if (line.starts_with(' ')) {
      block.push_back(line);
      continue;
    }
    if (!block.empty()) result += indented_block(block);
    block.clear();
    if (line.empty()) continue;
    if (!result.empty()) result += ".PP\n";
    result += sentences(line);
  }
  return result;
}

std::string see_also(const std::vector<std::string>& pages) {
  std::string text = ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < pages.size(); ++i)
    text += fmt::format(".BR {} (1){}\n", escaped(pages[i]), i + 1 < pages.size() ? "," : "");
  return text;
}

std::string page_of(const ProgramText& program, const std::string& subcommand) {
  return fmt::format("{}-{}", program.name, subcommand);
}

}  // namespace

std::string man_page(const ProgramText& program) {
  std::string text = header(program, program.name);
  text += fmt::format(".SH NAME\n{} \\- {}\n", escaped(program.name), escaped(program.what));
  text += fmt::format(
      ".SH SYNOPSIS\n.B {0}\n[\\fB\\-q\\fR] \\fICOMMAND\\fR ...\n.br\n.B {0}\n\\fBhelp\\fR "
      "[\\fICOMMAND\\fR | \\fITOPIC\\fR]\n",
      program.name);
  text += ".SH COMMANDS\n";
  std::vector<std::string> pages;
  for (const auto& subcommand : program.subcommands) {
    pages.push_back(page_of(program, subcommand.name));
    text += fmt::format(".TP\n.BR {} (1)\n{}", escaped(pages.back()), sentences(subcommand.what + "."));
  }
  text += ".SH OPTIONS\n";
  for (const auto& option : common_options()) text += tagged(option);
  for (const auto& topic : topics()) {
    text += fmt::format(".SH {}\n{}", title(topic.name),
                        paragraphs(fmt::format("{}.\n\n{}", topic.what, topic.text)));
  }
  return text + see_also(pages);
}

std::string man_page(const ProgramText& program, const SubcommandText& subcommand) {
  const auto name = page_of(program, subcommand.name);
  std::string text = header(program, name);
  text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n.B {} {}\n", escaped(name),
                      escaped(subcommand.what), program.name, escaped(subcommand.name));
  for (const auto& part : synopsis_parts(subcommand)) text += bold_options(part) + "\n";
  text += fmt::format(".SH DESCRIPTION\n{}", sentences(subcommand.what + "."));
  const auto add = [&](std::string_view heading, bool positional) {
    std::string items;
    for (const auto& argument : subcommand.arguments)
      if (argument.is_positional() == positional) items += tagged(argument);
    if (!positional)
      for (const auto& option : common_options()) items += tagged(option);
    if (!items.empty()) text += fmt::format(".SH {}\n{}", heading, items);
  };
  add("ARGUMENTS", true);
  add("OPTIONS", false);
  text += fmt::format(".SH EXIT STATUS\n{}", sentences(exit_codes_text() + "."));
  text += ".SH EXAMPLES\n";
  for (const auto& [command, what] : subcommand.examples)
    text += fmt::format(".TP\n.B {}\n{}", escaped(command), sentences(what));
  std::vector<std::string> pages{program.name};
  for (const auto& other : subcommand.see_also)
    if (program.find(other) != nullptr) pages.push_back(page_of(program, other));
  return text + see_also(pages);
}

}  // namespace fde::bench
