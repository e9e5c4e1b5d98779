// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/reports/command/program_text.hpp"

namespace fde::bench {

struct Streams;

// A subject of `fdebench help TOPIC`, a file of reports/command/topics: its first line says what it is about.
struct Topic {
  std::string_view name, what, text;
};
std::span<const Topic> topics();

struct Style {
  int columns = 80;
  bool colours = false;
};
Style output_style(const Streams& streams);  // of standard output

// The subcommands in groups, and the topics.
std::string overview_text(const ProgramText& program, const Style& style);
std::string help_text(const ProgramText& program, const SubcommandText& subcommand, const Style& style);
std::string topic_text(const Topic& topic, const Style& style);

// Manual pages in troff with the man macros: of the program, with the topics as sections, and of a
// subcommand.
std::string man_page(const ProgramText& program);
std::string man_page(const ProgramText& program, const SubcommandText& subcommand);

// The word with which a shell's script asks for candidates: fdebench __complete WORD...
inline constexpr std::string_view completion_request = "__complete";

// What a shell offers in place of the last of the words after the program's name, a line each: the word, a
// tab, and what it is. Candidates begin with the last word. A line that begins with a tab asks for files: the
// ending that they have, or "/" for folders, or nothing for all files.
std::string candidates(const ProgramText& program, std::vector<std::string> words,
                       const SceneRegistry& known);

// The script that a shell reads: of "bash", "zsh" or "fish".
std::string completion_script(const std::string& program, std::string_view shell);
const std::vector<std::string>& completion_shells();

// Texts for a terminal. Texts are ASCII but for what a user gave.

enum class Colour { bold, red, yellow, green };
std::string in_colour(std::string_view text, Colour colour, bool shown);  // unchanged unless shown

// Where the last column begins in a row of a table, "  name  description"; npos if the line is none.
std::size_t description_of_row(std::string_view line);

// Breaks paragraphs, which blank lines separate, into lines of up to `columns` characters, each indented by
// `indent` blanks. A line that begins with blanks is a row of a table, whose last column is wrapped, or stays
// as it is. Ends with a newline.
std::string wrapped(std::string_view text, int columns, int indent = 0);

// "  NAME   description" where the name fits into `width` characters, otherwise the name on a line of its
// own; the description is wrapped and aligned.
std::string wrapped_item(std::string_view name, std::string_view description, int width, int columns,
                         bool bold);

}  // namespace fde::bench
