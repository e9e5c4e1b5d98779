#include <unistd.h>

#include <iostream>

#include "command/command.hpp"

int main(int count, char** arguments) {
  std::ios::sync_with_stdio(false);
  return fde::run_fdebench({arguments + 1, arguments + count},
                           {.out = std::cout, .err = std::cerr, .terminal = isatty(STDERR_FILENO) != 0});
}
