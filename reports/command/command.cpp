// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <ostream>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <system_error>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/reports/command/help_text.hpp"

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

// A subcommand by its name, made when it is called or its texts are asked for.
struct NamedCommand {
  std::string_view name;
  Command (*declared)();

  [[nodiscard]] Command made() const {
    Command command = declared();
    set_choices(command.text.arguments);
    return command;
  }
};
constexpr std::array subcommands{NamedCommand{"solve", solve_command},
                                 NamedCommand{"choose", choose_command},
                                 NamedCommand{"run", run_command},
                                 NamedCommand{"report", report_command},
                                 NamedCommand{"study", study_command},
                                 NamedCommand{"judge", judge_command},
                                 NamedCommand{"fit", fit_command},
                                 NamedCommand{"compare", compare_command},
                                 NamedCommand{"merge", merge_command},
                                 NamedCommand{"export", export_command},
                                 NamedCommand{"plot", plot_command},
                                 NamedCommand{"scenes", scenes_command},
                                 NamedCommand{"schemes", schemes_command},
                                 NamedCommand{"exact", exact_command},
                                 NamedCommand{"mittag-leffler", mittag_leffler_command},
                                 NamedCommand{"stability", stability_command},
                                 NamedCommand{"poles", poles_command},
                                 NamedCommand{"response", response_command},
                                 NamedCommand{"geometry", geometry_command},
                                 NamedCommand{"reference", reference_command},
                                 NamedCommand{"help", help_command},
                                 NamedCommand{"completion", completion_command}};

const NamedCommand& command_named(const std::string& name) {
  const auto* const found = std::ranges::find(subcommands, name, &NamedCommand::name);
  if (found != subcommands.end()) return *found;
  std::vector<std::string_view> names;
  for (const NamedCommand& command : subcommands) names.push_back(command.name);
  throw std::invalid_argument(fmt::format("command {}: no such command{}; there are {}", name,
                                          did_you_mean(name, names), fmt::join(names, ", ")));
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

void check_none_empty(const std::vector<std::string>& arguments) {
  const auto found = std::ranges::find(arguments, "");
  if (found == arguments.end()) return;
  throw std::invalid_argument(fmt::format("argument {} is empty", found - arguments.begin() + 1));
}

// The options in front of the name of a command, which may stand behind it too, but for --version.
bool asks_for_version(std::span<const std::string> options) {
  constexpr std::array known{"-q", "--quiet", "-h", "--help", "-V", "--version"};
  for (const auto& option : options) {
    if (std::ranges::find(known, option.substr(0, option.find('='))) == known.end()) {
      throw std::invalid_argument(
          fmt::format("{}: no such option; {} help lists the subcommands", option, name_of_program));
    }
  }
  return std::ranges::any_of(options, [](const auto& word) { return word == "-V" || word == "--version"; });
}

void run_words(std::vector<std::string> words, Streams& streams, const SceneRegistry& known) {
  const auto name = std::ranges::find_if(words, [](const auto& word) { return !word.starts_with('-'); });
  if (asks_for_version({words.begin(), name})) {
    streams.out << this_session().version << '\n';
    return;
  }
  if (name == words.end()) {
    if (std::ranges::none_of(words, [](const auto& word) { return word == "-h" || word == "--help"; })) {
      throw std::invalid_argument(
          fmt::format("A subcommand is required; {} help lists the subcommands", name_of_program));
    }
    streams.out << overview_text(program_text(), output_style(streams));
    return;
  }
  const Command command = command_named(*name).made();
  words.erase(name);
  const auto given = parse_words(command.text, words, streams.quiet);
  given ? command.run(*given, streams, known)
        : void(streams.out << help_text(program_text(), command.text, output_style(streams)));
}

}  // namespace

ProgramText program_text() {
  ProgramText program{.name = name_of_program, .what = purpose, .version = this_session().version};
  for (const NamedCommand& command : subcommands) program.subcommands.push_back(command.made().text);
  return program;
}

void say(const Streams& streams, Message kind, std::string_view message) {
  if (kind == Message::note && streams.quiet) return;
  const bool coloured = streams.columns > 0 && streams.colours;
  const auto speaker = in_colour("fdebench:", Colour::red, coloured && kind == Message::error);
  const auto warning = kind == Message::warning ? in_colour("warning:", Colour::yellow, coloured) + " " : "";
  streams.err << fmt::format("{} {}{}\n", speaker, warning, printable(message));
  streams.err.flush();
}

void warn(const Streams& streams, std::string_view text) {
  if (!text.empty()) say(streams, Message::warning, text);
}

int run_fdebench(const std::vector<std::string>& arguments, const Streams& given,
                 const SceneRegistry& known) {
  Streams streams = given;
  try {
    const SceneRegistry named = with_equation_files(known, said_once(streams));
    if (!arguments.empty() && arguments.front() == completion_request) {
      streams.out << candidates(program_text(), {arguments.begin() + 1, arguments.end()}, named);
      return 0;
    }
    check_none_empty(arguments);
    run_words(arguments, streams, named);
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
