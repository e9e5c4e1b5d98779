// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <ostream>
#include <system_error>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/reports/command/command_line.hpp"

namespace fde::bench {
namespace {

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

int complain(const Streams& streams, int code, std::string_view message) {
  streams.err << fmt::format("fdebench: {}\n", printable(message));
  return code;
}

// CLI11 takes an empty argument for the name of an option group and does not terminate. No argument of
// fdebench may be empty.
void check_none_empty(const std::vector<std::string>& arguments) {
  const auto found = std::ranges::find(arguments, "");
  if (found == arguments.end()) return;
  throw std::invalid_argument(fmt::format("argument {} is empty", found - arguments.begin() + 1));
}

// CLI11's own message only says that a subcommand is missing.
void check_subcommand(const CommandLine& program, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return;
  const auto names = program.subcommands();
  if (std::ranges::find(names, arguments.front()) != names.end()) return;
  throw std::invalid_argument(fmt::format("command {}: no such command{}; there are {}", arguments.front(),
                                          did_you_mean(arguments.front(), {names.begin(), names.end()}),
                                          fmt::join(names, ", ")));
}

}  // namespace

int run_fdebench(const std::vector<std::string>& arguments, const Streams& streams,
                 const SceneRegistry& known) {
  try {
    const SceneRegistry named = with_equation_files(known);
    CommandLine program("fdebench",
                        "Which numerical scheme to use for a fractional differential equation, with proof",
                        this_session().version);
#define FDE_COMMAND(file) add_##file(program, streams, named);
#include "fdebench/reports/command/list.def"
#undef FDE_COMMAND
    check_none_empty(arguments);
    check_subcommand(program, arguments);
    program.run(arguments, streams.out, streams.err);
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
