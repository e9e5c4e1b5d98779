// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <span>

#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

namespace fde::bench::c {
namespace {

constexpr auto option_names = {"accuracy", "at",    "budget",  "check",    "columns",  "error",
                               "every",    "grid",  "history", "max-time", "norm",     "points",
                               "runs",     "scale", "steps",   "threads",  "tolerance"};

// Sets the option to the text that `text` returns.
template <typename Text>
int set(FdebenchOptions* options, const char* name, const Text& text) {
  return guarded([&] {
    auto& texts = given("options", options, options_handle).texts;
    const auto option = text_of("name", name);
    if (std::ranges::find(option_names, option) == option_names.end()) {
      throw std::invalid_argument(
          fmt::format("name = {}: must be of {}", option, fmt::join(option_names, ", ")));
    }
    texts[option] = text();
  });
}

}  // namespace
}  // namespace fde::bench::c

using namespace fde::bench::c;

int fdebench_options_new(fdebench_options** options) {
  return guarded([&] {
    auto& result = given("options", options);
    result = std::make_unique<FdebenchOptions>().release();
  });
}

int fdebench_options_set_integer(fdebench_options* options, const char* name, long long value) {
  return set(options, name, [&] { return fmt::format("{}", value); });
}

int fdebench_options_set_real(fdebench_options* options, const char* name, double value) {
  return set(options, name, [&] { return fmt::format("{}", value); });
}

int fdebench_options_set_reals(fdebench_options* options, const char* name, size_t count,
                               const double* values) {
  return set(options, name, [&] {
    require_count("count", count, 1, most_entries);
    return fmt::format("{}", fmt::join(std::span(&given("values", values, "the numbers"), count), ","));
  });
}

int fdebench_options_set_text(fdebench_options* options, const char* name, const char* value) {
  return set(options, name, [&] { return text_of("value", value); });
}

void fdebench_options_free(fdebench_options* options) { delete options; }
