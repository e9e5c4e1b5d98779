// SPDX-License-Identifier: MIT
// Preloaded, counts the bytes that a program allocates, and writes them to the file $ALLOCATED_BYTES at its
// end.
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): glibc's own functions.
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* place, std::size_t bytes);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
}

namespace {

std::atomic<std::size_t> allocated = 0;

struct AtTheEnd {
  ~AtTheEnd() {
    const char* const name = std::getenv("ALLOCATED_BYTES");
    std::FILE* const file = name == nullptr ? nullptr : std::fopen(name, "w");
    if (file == nullptr) return;
    std::fprintf(file, "%zu\n", allocated.load());
    std::fclose(file);
  }
} at_the_end;

}  // namespace

extern "C" {
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name): those of glibc are reserved.
void* malloc(std::size_t bytes) {
  allocated += bytes;
  return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  allocated += count * bytes;
  return __libc_calloc(count, bytes);
}
void* realloc(void* place, std::size_t bytes) {
  allocated += bytes;
  return __libc_realloc(place, bytes);
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)
}
