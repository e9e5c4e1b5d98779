// SPDX-License-Identifier: MIT
// A copy of the variable stderr, for the linker's --wrap=stderr: fde_shared_with_asmjit in CMakeLists.txt
// says why.
#include <cstdio>

extern "C" {
extern std::FILE* stderr_of_library __asm__("__real_stderr");
[[gnu::visibility("hidden"),
  gnu::used]] std::FILE* stderr_of_ours __asm__("__wrap_stderr") = stderr_of_library;
}
