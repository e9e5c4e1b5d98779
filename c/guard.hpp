// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fde::bench::c {

// Thrown where a callback returns another number than 0. No std::runtime_error: that means a numerical
// failure.
class CallbackStop : public std::exception {
 public:
  CallbackStop(std::string_view callback, double t, int code)
      : code_(code), text_(fmt::format("{}: returned {} at t = {}", callback, code, t)) {}
  [[nodiscard]] int code() const noexcept { return code_; }
  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }

 private:
  int code_;
  std::string text_;
};

// Keeps the exception that is being handled for fdebench_last_error, and returns its fdebench_status.
int kept_error() noexcept;

// Runs the body of a function of the interface; returns its fdebench_status.
template <typename Body>
int guarded(const Body& body) noexcept {
  try {
    body();
    return 0;
  } catch (...) {
    return kept_error();
  }
}

// What a pointer of the caller points to. Throws std::invalid_argument if it is null.
template <typename Value>
Value& given(const char* name, Value* pointer, const char* allowed = "a place for the result") {
  if (pointer == nullptr) throw std::invalid_argument(fmt::format("{} = NULL: must be {}", name, allowed));
  return *pointer;
}

// A text of the caller, not empty.
std::string text_of(const char* name, const char* text);

// Throws std::invalid_argument unless low <= count <= high.
void require_count(const char* name, std::size_t count, std::size_t low, std::size_t high);

// Throws std::invalid_argument unless there are names at this index, and this many places.
void require_index(const char* name, std::size_t index, std::size_t size);
void require_capacity(std::size_t capacity, std::size_t needed);

inline constexpr std::size_t most_entries = 10'000'000;

}  // namespace fde::bench::c
