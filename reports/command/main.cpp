// SPDX-License-Identifier: MIT
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "fdebench/reports/command/command.hpp"

namespace {

// Width of the terminal of a file descriptor; 80 if unknown, 0 if it is no terminal.
int columns_of_terminal(int descriptor) {
  constexpr int usual = 80;
  if (isatty(descriptor) == 0) return 0;
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return size.ws_col;
}

// Whether colours are wanted on terminals: not with NO_COLOR (no-color.org), and not on a dumb terminal.
bool wants_colours() {
  const char* const none = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): nothing sets it
  const char* const terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nothing sets it
  return (none == nullptr || *none == '\0') && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

int main(int count, char** arguments) {
  std::ios::sync_with_stdio(false);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow fails like a full disk
  return fde::bench::run_fdebench({arguments + 1, arguments + count},
                                  {.out = std::cout,
                                   .err = std::cerr,
                                   .columns = columns_of_terminal(STDERR_FILENO),
                                   .out_columns = columns_of_terminal(STDOUT_FILENO),
                                   .colours = wants_colours()});
}
