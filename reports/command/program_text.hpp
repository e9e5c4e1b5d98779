// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/text/count_range.hpp"
#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {

// What help, manual pages and completions say of a program: its subcommands with their arguments.

// The values of an argument: anything, a number, a whole number, one of some words, or what a text says.
using Words = std::vector<std::string>;
using Allowed = std::variant<std::monostate, Range, CountRange, Words, std::string>;
std::string allowed_text(const Allowed& allowed);  // as refusals say it; "" for anything
std::string choice_text(const Words& words);       // "a, b or c"

// What a shell offers for the value of an argument.
enum class Completion {
  nothing,
  scene,
  scheme,
  setting,  // NAME=, a parameter of the scene
  results,  // a results file
  file,
  folder,
  topic,
  command
};

struct ArgumentText {
  std::string name;   // "--steps"; without dashes: positional
  std::string what;   // what it is for
  std::string value;  // stands for the value, "N"; empty: a flag
  Allowed allowed{};
  std::string unit{}, usual{};  // the usual value is the default
  Completion completion = Completion::nothing;
  Words offered{};  // what a shell offers besides
  bool required = false, repeated = false;
  int choice = 0;  // arguments with the same number exclude each other; 0: none

  [[nodiscard]] bool is_positional() const { return !name.starts_with('-'); }
};

struct SubcommandText {
  std::string name, what, group;
  std::deque<ArgumentText> arguments{};
  std::vector<std::pair<std::string, std::string>> examples{};  // a command, and what it does
  std::vector<std::string> see_also{};                          // subcommands and topics
};

struct ProgramText {
  std::string name, what, version;
  std::deque<SubcommandText> subcommands{};

  [[nodiscard]] const SubcommandText* find(const std::string& subcommand) const;  // nullptr: none
};

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
