// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

namespace fde::bench {

// An interval of allowed values. An open end is not allowed itself.
struct Range {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool open_low = false;
  bool open_high = false;

  [[nodiscard]] bool contains(double value) const;  // false for nan
  [[nodiscard]] std::string text() const;           // "a number in (0, 2]"
};

constexpr Range any_number{};
constexpr Range positive{.low = 0.0, .open_low = true};
constexpr Range not_negative{.low = 0.0};
constexpr Range order_up_to_one{.low = 0.0, .high = 1.0, .open_low = true};
constexpr Range order_up_to_two{.low = 0.0, .high = 2.0, .open_low = true};
constexpr Range order_below_one{.low = 0.0, .high = 1.0, .open_low = true, .open_high = true};
constexpr Range order_below_two{.low = 0.0, .high = 2.0, .open_low = true, .open_high = true};

// Allowed whole numbers, both ends among them.
struct CountRange {
  int lowest = 0, highest = 0;

  [[nodiscard]] std::string text() const;  // "a whole number from 1 to 100"
};

}  // namespace fde::bench
