// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace fde::bench {

// A subject of `fdebench help TOPIC`, a file of reports/command/topics: its first line says what it is about.
struct Topic {
  std::string_view name, what, text;
};

std::span<const Topic> topics();

}  // namespace fde::bench
