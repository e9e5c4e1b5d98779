// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

namespace fde::bench::c {
namespace {

constexpr auto option_names = {"accuracy", "at",    "budget",  "check",    "columns",  "error",
                               "every",    "grid",  "history", "max-time", "norm",     "points",
                               "runs",     "scale", "steps",   "threads",  "tolerance"};

// Sets the option to the value that `value` returns.
template <typename Make>
int set(FdebenchOptions* options, const char* name, const Make& value) {
  return guarded([&] {
    auto& values = given("options", options, options_handle).values;
    const auto option = text_of("name", name);
    if (std::ranges::find(option_names, option) == option_names.end()) {
      throw std::invalid_argument(
          fmt::format("name = {}: must be of {}", option, fmt::join(option_names, ", ")));
    }
    values.insert_or_assign(option, OptionValue(value()));
  });
}

// Numbers in the fewest digits that tell them from all others.
struct ValueText {
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const std::vector<double>& numbers) const {
    return fmt::format("{}", fmt::join(numbers, ","));
  }
  std::string operator()(auto number) const { return fmt::format("{}", number); }
};

// The number of an option that holds one; nullopt: a text, or several numbers.
std::optional<double> number_of(const OptionValue& value) {
  if (const auto* integer = std::get_if<long long>(&value)) return static_cast<double>(*integer);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  const auto* list = std::get_if<std::vector<double>>(&value);
  return list != nullptr && list->size() == 1 ? std::optional(list->front()) : std::nullopt;
}

}  // namespace

std::string text_of(const OptionValue& value) { return std::visit(ValueText(), value); }

double real_of(const std::string& name, const OptionValue& value, const Range& allowed) {
  const auto number = number_of(value);
  if (!number) return parse_number(name, text_of(value), allowed);
  require_in(name, *number, allowed);
  return *number;
}

int count_of(const std::string& name, const OptionValue& value, const CountRange& allowed) {
  const auto number = number_of(value);
  if (!number) return parse_count(name, text_of(value), allowed.lowest, allowed.highest);
  if (!(*number >= allowed.lowest && *number <= allowed.highest && *number == std::floor(*number)))
    reject_text(name, text_of(value), allowed.text());
  return static_cast<int>(*number);
}

std::vector<double> reals_of(const std::string& name, const OptionValue& value, const Range& allowed) {
  if (const auto* text = std::get_if<std::string>(&value)) return parse_numbers(name, *text, allowed);
  const auto* list = std::get_if<std::vector<double>>(&value);
  auto numbers = list != nullptr ? *list : std::vector{number_of(value).value()};
  for (const double number : numbers) require_in(name, number, allowed);
  return numbers;
}

}  // namespace fde::bench::c

using namespace fde::bench::c;

int fdebench_options_new(fdebench_options** options) {
  return guarded([&] {
    auto& result = given("options", options);
    result = std::make_unique<FdebenchOptions>().release();
  });
}

int fdebench_options_set_integer(fdebench_options* options, const char* name, long long value) {
  return set(options, name, [&] { return value; });
}

int fdebench_options_set_real(fdebench_options* options, const char* name, double value) {
  return set(options, name, [&] { return value; });
}

int fdebench_options_set_reals(fdebench_options* options, const char* name, size_t count,
                               const double* values) {
  return set(options, name, [&] {
    require_count("count", count, 1, most_entries);
    const double* first = &given("values", values, "the numbers");
    return std::vector(first, first + count);
  });
}

int fdebench_options_set_text(fdebench_options* options, const char* name, const char* value) {
  return set(options, name, [&] { return text_of("value", value); });
}

void fdebench_options_free(fdebench_options* options) { delete options; }
