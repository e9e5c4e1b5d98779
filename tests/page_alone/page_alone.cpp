// SPDX-License-Identifier: MIT
// fde_page_alone RESULTS FOLDER: the page of a results file, in a program that aborts where it makes a scene,
// computes a reference, or reads a clock or the environment (--wrap of the linker, CMakeLists.txt).

#include <cstdio>
#include <cstdlib>

#include "fdebench/reports/page/report.hpp"

namespace {

[[noreturn]] void must_not_be_called(const char* what) {
  std::fprintf(stderr, "the page calls %s\n", what);
  std::abort();
}

}  // namespace

#define FDE_MUST_NOT_BE_CALLED(symbol) \
  extern "C" void __wrap_##symbol() { must_not_be_called(#symbol); }  // NOLINT(bugprone-reserved-identifier)
#include "page_alone/symbols.def"
#undef FDE_MUST_NOT_BE_CALLED

int main(int count, char** arguments) {
  if (count != 3) return 2;
  fde::bench::write_report(fde::bench::read_runs(arguments[1]), arguments[2]);
}
