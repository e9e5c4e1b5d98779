// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <system_error>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/reports/command/command_line.hpp"
#include "fdebench/reports/command/completion.hpp"
#include "fdebench/reports/command/terminal_text.hpp"

namespace fde::bench {
namespace {

constexpr auto name_of_program = "fdebench";
constexpr auto purpose = "Which numerical scheme to use for a fractional differential equation, with proof";

constexpr int worse_results = 1;
constexpr int bad_input = 2;
constexpr int numerical_failure = 3;

// The message as one line without control characters: arguments in it may contain any bytes.
std::string printable(std::string_view message) {
  constexpr unsigned char first_printable = ' ', erase = 0x7f;
  std::string line;
  for (const char c : message) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
      line += ' ';
    } else if (byte < first_printable || byte == erase) {
      line += fmt::format("\\x{:02x}", byte);
    } else {
      line += c;
    }
  }
  return line;
}

void add_subcommands(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
#define FDE_COMMAND(file) add_##file(program, streams, known);
#include "fdebench/reports/command/list.def"
#undef FDE_COMMAND
}

int complain(const Streams& streams, int code, std::string_view message) {
  say(streams, Message::error, message);
  return code;
}

// Says each note once: a command makes a scene several times, also in several threads.
NoteReceiver said_once(const Streams& streams) {
  struct Notes {
    std::mutex mutex{};
    std::set<std::string> said{};
  };
  return [&streams, notes = std::make_shared<Notes>()](const std::string& note) {
    const std::lock_guard lock(notes->mutex);
    if (notes->said.insert(note).second) say(streams, Message::note, note);
  };
}

// CLI11 takes an empty argument for the name of an option group and does not terminate. No argument of
// fdebench may be empty.
void check_none_empty(const std::vector<std::string>& arguments) {
  const auto found = std::ranges::find(arguments, "");
  if (found == arguments.end()) return;
  throw std::invalid_argument(fmt::format("argument {} is empty", found - arguments.begin() + 1));
}

// CLI11's own message only says that a subcommand is missing.
void check_subcommand(const ProgramText& program, const std::vector<std::string>& arguments) {
  const auto first =
      std::ranges::find_if(arguments, [](const auto& word) { return word != "-q" && word != "--quiet"; });
  if (first == arguments.end() || first->starts_with('-') || program.find(*first) != nullptr) return;
  std::vector<std::string_view> names;
  for (const auto& subcommand : program.subcommands) names.push_back(subcommand.name);
  throw std::invalid_argument(fmt::format("command {}: no such command{}; there are {}", *first,
                                          did_you_mean(*first, names), fmt::join(names, ", ")));
}

}  // namespace

ProgramText program_text() {
  std::ostringstream nowhere;
  Streams streams{.out = nowhere, .err = nowhere};
  CommandLine program(name_of_program, purpose, this_session().version, streams.quiet);
  add_subcommands(program, streams, built_in_scenes());
  return program.text();
}

void say(const Streams& streams, Message kind, std::string_view message) {
  if (kind == Message::note && streams.quiet) return;
  const bool coloured = streams.columns > 0 && streams.colours;
  constexpr std::string_view warning = "warning:";
  const auto line = printable(message);
  if (kind == Message::warning && line.starts_with(warning)) {
    streams.err << fmt::format("fdebench: {}{}\n", in_colour(warning, Colour::yellow, coloured),
                               line.substr(warning.size()));
  } else {
    streams.err << fmt::format("{} {}\n",
                               in_colour("fdebench:", Colour::red, coloured && kind == Message::error), line);
  }
  streams.err.flush();
}

void warn(const Streams& streams, std::string_view text) {
  if (!text.empty()) say(streams, Message::warning, fmt::format("warning: {}", text));
}

int run_fdebench(const std::vector<std::string>& arguments, const Streams& given,
                 const SceneRegistry& known) {
  Streams streams = given;
  try {
    const SceneRegistry named = with_equation_files(known, said_once(streams));
    CommandLine program(name_of_program, purpose, this_session().version, streams.quiet);
    add_subcommands(program, streams, named);
    if (!arguments.empty() && arguments.front() == completion_request) {
      streams.out << candidates(program.text(), {arguments.begin() + 1, arguments.end()}, named);
      return 0;
    }
    check_none_empty(arguments);
    check_subcommand(program.text(), arguments);
    program.run(arguments, streams);
    streams.out.flush();
    return streams.out.good() ? 0 : complain(streams, bad_input, "standard output: cannot be written");
  } catch (const WorseResults& worse) {
    streams.out.flush();
    return streams.out.good() ? complain(streams, worse_results, worse.what())
                              : complain(streams, bad_input, "standard output: cannot be written");
  } catch (const NumericalFailure& failure) {
    return complain(streams, numerical_failure, failure.what());
  } catch (const std::invalid_argument& error) {
    return complain(streams, bad_input, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(streams, bad_input,
                    fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::system_error& error) {
    return complain(streams, bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return complain(streams, bad_input, "not enough memory for this number of steps");
  } catch (const std::runtime_error& failure) {
    return complain(streams, numerical_failure, failure.what());
  }
}

}  // namespace fde::bench
