#include "command/command.hpp"

#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <new>
#include <ostream>
#include <system_error>
#include <utility>

#include "records/record.hpp"
#include "scenes/parameters.hpp"

namespace fde {
namespace {

constexpr int bad_input = 2;
constexpr int numerical_failure = 3;

// One line that changes nothing on a terminal, whatever the arguments held.
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
  fmt::print(streams.err, "fdebench: {}\n", printable(message));
  return code;
}

// CLI11 takes a minus before a digit for a number, before a point for an option.
std::string with_leading_zero(const std::string& argument) {
  constexpr std::string_view digits = "0123456789";
  const bool number = argument.starts_with("-.") && argument.find_first_of(digits) == 2;
  return number ? "-0" + argument.substr(1) : argument;
}

// CLI11 takes the arguments from the last to the first.
int dispatch(CLI::App& app, const std::vector<std::string>& arguments, const Streams& streams) {
  try {
    std::vector<std::string> backwards;
    std::transform(arguments.rbegin(), arguments.rend(), std::back_inserter(backwards), with_leading_zero);
    app.parse(std::move(backwards));
  } catch (const CLI::Success& help) {
    app.exit(help, streams.out, streams.err);
  } catch (const CLI::ParseError& error) {
    return complain(streams, bad_input, error.what());
  }
  streams.out.flush();
  return streams.out.good() ? 0 : complain(streams, bad_input, "standard output: cannot be written");
}

// CLI11 takes an empty argument for the name of a group of options, without end. No argument of ours may be
// empty.
void check_none_empty(const std::vector<std::string>& arguments) {
  const auto found = std::ranges::find(arguments, "");
  if (found == arguments.end()) return;
  throw std::invalid_argument(fmt::format("argument {} is empty", found - arguments.begin() + 1));
}

// CLI11 only says that a subcommand is missing.
void check_subcommand(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return;
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, arguments.front()) != names.end()) return;
  throw std::invalid_argument(fmt::format("command {}: no such command{}; there are {}", arguments.front(),
                                          nearest(arguments.front(), {names.begin(), names.end()}),
                                          fmt::join(names, ", ")));
}

}  // namespace

int run_fdebench(const std::vector<std::string>& arguments, const Streams& streams, const Scenes& known) {
  CLI::App app{"Which numerical scheme to use for a fractional differential equation, with proof",
               "fdebench"};
  app.require_subcommand(1);
  app.set_version_flag("--version", this_session().version);
#define FDE_COMMAND(file) add_##file(app, streams, known);
#include "command/list.def"
#undef FDE_COMMAND
  try {
    check_none_empty(arguments);
    check_subcommand(app, arguments);
    return dispatch(app, arguments, streams);
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

}  // namespace fde
