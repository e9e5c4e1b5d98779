// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>

// A fuzz target takes any bytes and aborts if a promise is broken. libFuzzer fuzzes it, in a program of its
// own, or replay.cpp runs it on the files of its corpus.
#ifdef FDE_LIBFUZZER
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
#define FDE_FUZZ_TARGET(name) int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#else
namespace fde::bench::fuzz {
int command_line(const std::uint8_t* data, std::size_t size);
int equation_file(const std::uint8_t* data, std::size_t size);
int mittag_leffler(const std::uint8_t* data, std::size_t size);
int parameter_values(const std::uint8_t* data, std::size_t size);
int prabhakar(const std::uint8_t* data, std::size_t size);
int records(const std::uint8_t* data, std::size_t size);
int reference_files(const std::uint8_t* data, std::size_t size);
}  // namespace fde::bench::fuzz
#define FDE_FUZZ_TARGET(name) int fde::bench::fuzz::name(const std::uint8_t* data, std::size_t size)
#endif

namespace fde::bench::fuzz {

// Aborts if a promise is broken, which the fuzzer detects.
inline void require(bool holds, std::string_view what, std::string_view shown = "") {
  if (holds) return;
  fmt::print(stderr, "BROKEN: {}\n{}\n", what, shown);
  std::abort();
}

// Runs a call, which must return or throw with a one-line message.
template <class Call>
void require_one_line_errors(const Call& call) {
  const auto check = [](std::string_view message) {
    require(!message.empty() && message.find('\n') == std::string_view::npos, "one line", message);
  };
  try {
    call();
  } catch (const std::invalid_argument& refusal) {
    check(refusal.what());
  } catch (const std::runtime_error& failure) {
    check(failure.what());
  }
}

// Takes numbers from the front of the input; zeros after its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : rest_(reinterpret_cast<const char*>(data), size) {}

  template <typename Number>
  Number take() {
    Number number{};
    const auto count = std::min(sizeof(Number), rest_.size());
    std::memcpy(&number, rest_.data(), count);
    rest_.remove_prefix(count);
    return number;
  }
  // An index below `count`.
  std::size_t index_below(std::size_t count) { return take<std::uint8_t>() % count; }
  // The text up to the next line end.
  std::string_view line() {
    const auto text = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(text.size() + 1, rest_.size()));
    return text;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] bool empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

// Whether a text contains nan or inf as a number.
inline bool contains_nan_or_inf(std::string_view text) {
  for (const std::string_view word : {"nan", "-nan", "inf", "-inf"}) {
    for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const auto separates = [](char c) {
        return std::string_view(" ,;:\"\n[]").find(c) != std::string_view::npos;
      };
      const auto end = at + word.size();
      if ((at == 0 || separates(text[at - 1])) && (end == text.size() || separates(text[end]))) return true;
    }
  }
  return false;
}

}  // namespace fde::bench::fuzz
