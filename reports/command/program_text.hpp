// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {

// What a program takes: its parser, its help, its manual pages and its completions follow from these texts.

// The values of an argument: those of a kind that a shell offers, a number, a whole number, or one of some
// words. `setting` is NAME=, a parameter of the scene; `results` are results files.
enum class Completion { nothing, scene, scheme, setting, grid, results, file, folder, topic };
using Words = std::vector<std::string>;
using Allowed = std::variant<Completion, Range, CountRange, Words>;
std::string allowed_text(const Allowed& allowed);  // as refusals say it; "" for anything
std::string choice_text(const Words& words);       // "a, b or c"

// `form` is the argument as a synopsis has it: "--gamma G", "[--until T]", "[--json]", "[--scheme ID]...",
// "SCENE"; of arguments that exclude each other "[--at T1,T2,... |", "--every K |", "--points K]". A
// positional argument is named by its value in small letters, or in front of it: "files:FILE...".
struct ArgumentText {
  ArgumentText(std::string_view form, std::string what_for, Allowed values = {}, std::string by_default = {});

  std::string name, value;  // "--steps" and what stands for its value, "N"; empty: a flag
  std::string what;         // what it is for
  Allowed allowed;
  std::string usual;  // the default
  bool required, repeated, begins_choice, ends_choice;
  int choice = 0;  // set_choices(): arguments with the same number exclude each other; 0: none

  [[nodiscard]] bool is_positional() const { return !name.starts_with('-'); }
};

struct SubcommandText {
  std::string name, group, what;
  std::vector<ArgumentText> arguments;
  std::vector<std::pair<std::string, std::string>> examples;  // a command, and what it does
  std::vector<std::string> see_also;                          // subcommands and topics

  [[nodiscard]] const ArgumentText* find(std::string_view argument) const;  // nullptr: none
};

struct ProgramText {
  std::string name, what, version;
  std::vector<SubcommandText> subcommands{};

  [[nodiscard]] const SubcommandText* find(std::string_view subcommand) const;  // nullptr: none
  [[nodiscard]] std::vector<std::string_view> names() const;                    // of the subcommands
};

// Numbers the choices of a subcommand's arguments, which are required as the first of them is.
void set_choices(std::vector<ArgumentText>& arguments);

// The names of a flag as they are shown: "-q, --quiet".
std::string display_name(const ArgumentText& flag);

// The options that every subcommand has.
const std::vector<ArgumentText>& common_options();

// "0 done; 1 ...": what the exit codes mean, in one line.
std::string exit_codes_text();

// "SCENE", "--scheme ID", "[--steps N | --accuracy E]": the parts of a synopsis after the program and the
// name.
std::vector<std::string> synopsis_parts(const SubcommandText& subcommand);
// The synopsis in lines of up to `columns` characters.
std::string synopsis(const std::string& program, const SubcommandText& subcommand, int columns);

// What an argument is for, with its allowed values, unit and default: "number of steps; a whole number from 1
// to 1000000000".
std::string full_description(const ArgumentText& argument);

}  // namespace fde::bench
