#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>

#include "command/command.hpp"

namespace {

// Those of the terminal that standard error is, 80 where it does not tell; 0: it is none.
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
  return fde::run_fdebench({arguments + 1, arguments + count},
                           {.out = std::cout, .err = std::cerr, .columns = columns_of_terminal()});
}
