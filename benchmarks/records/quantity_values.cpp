// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/quantity_values.hpp"

#include <algorithm>
#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace fde::bench {
namespace {

// The same id, as long as the process lives.
std::string_view stored_once(std::string_view id) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> ids;
  const std::scoped_lock lock(mutex);
  const auto found = ids.find(id);
  return found == ids.end() ? *ids.emplace(id).first : *found;
}

}  // namespace

void QuantityValues::set(std::string_view quantity, double value) {
  const auto found = std::ranges::find(values_, quantity, &Value::first);
  if (found == values_.end()) {
    values_.emplace_back(stored_once(quantity), value);
  } else {
    found->second = value;
  }
}

void QuantityValues::erase(std::string_view quantity) {
  std::erase_if(values_, [&](const Value& value) { return value.first == quantity; });
}

std::optional<double> QuantityValues::operator[](std::string_view quantity) const {
  const auto found = std::ranges::find(values_, quantity, &Value::first);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace fde::bench
