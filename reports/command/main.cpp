// SPDX-License-Identifier: MIT
#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>

#include "fdebench/reports/command/command.hpp"

namespace {

// Width of the terminal of standard error; 80 if unknown, 0 if standard error is no terminal.
int columns_of_terminal() {
  constexpr int usual = 80;
  if (isatty(STDERR_FILENO) == 0) return 0;
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return size.ws_col;
}

}  // namespace

int main(int count, char** arguments) {
  std::ios::sync_with_stdio(false);
  return fde::bench::run_fdebench({arguments + 1, arguments + count},
                                  {.out = std::cout, .err = std::cerr, .columns = columns_of_terminal()});
}
