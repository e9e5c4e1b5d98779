// SPDX-License-Identifier: MIT
#include "fdebench/c/guard.hpp"

#include <fdebench.h>
#include <mpfr.h>

#include <new>
#include <system_error>

namespace fde::bench::c {
namespace {

struct LastError {
  std::string text{};
  const char* shown = "";  // of `text`, or a literal where there is no memory
  int callback_code = 0;
};

// Of each thread: another one's failure does not change it.
LastError& last_error() {
  thread_local LastError kept;
  return kept;
}

int keep(int status, const char* message) noexcept {
  LastError& kept = last_error();
  try {
    kept.text = message;
    kept.shown = kept.text.c_str();
  } catch (...) {
    kept.shown = "not enough memory";
  }
  return status;
}

}  // namespace

int kept_error() noexcept {
  try {
    throw;
  } catch (const CallbackStop& stop) {
    last_error().callback_code = stop.code();
    return keep(FDEBENCH_STOPPED, stop.what());
  } catch (const std::bad_alloc&) {
    return keep(FDEBENCH_NO_MEMORY, "not enough memory");
  } catch (const std::length_error&) {
    return keep(FDEBENCH_NO_MEMORY, "not enough memory");
  } catch (const std::invalid_argument& error) {
    return keep(FDEBENCH_BAD_ARGUMENT, error.what());
  } catch (const std::system_error& error) {  // a file that cannot be read
    return keep(FDEBENCH_BAD_ARGUMENT, error.what());
  } catch (const std::runtime_error& failure) {
    return keep(FDEBENCH_NUMERICAL_FAILURE, failure.what());
  } catch (const std::exception& error) {
    return keep(FDEBENCH_INTERNAL, error.what());
  } catch (...) {
    return keep(FDEBENCH_INTERNAL, "an unknown exception");
  }
}

std::string text_of(const char* name, const char* text) {
  std::string copy = &given(name, text, "a text");
  if (copy.empty()) throw std::invalid_argument(fmt::format("{} = \"\": must not be empty", name));
  return copy;
}

void require_count(const char* name, std::size_t count, std::size_t low, std::size_t high) {
  if (count < low || count > high)
    throw std::invalid_argument(fmt::format("{} = {}: must be in [{}, {}]", name, count, low, high));
}

void require_index(const char* name, std::size_t index, std::size_t size) {
  if (index >= size) throw std::invalid_argument(fmt::format("{} = {}: must be below {}", name, index, size));
}

void require_capacity(std::size_t capacity, std::size_t needed) {
  if (capacity < needed)
    throw std::invalid_argument(fmt::format("capacity = {}: must be at least {}", capacity, needed));
}

}  // namespace fde::bench::c

using fde::bench::c::last_error;

const char* fdebench_last_error(void) { return last_error().shown; }

int fdebench_callback_code(void) { return last_error().callback_code; }

const char* fdebench_version(void) { return FDEBENCH_VERSION; }

int fdebench_abi(void) { return FDEBENCH_ABI; }

void fdebench_end_thread(void) { mpfr_free_cache(); }
