// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/by_quantity.hpp"

#include <functional>
#include <mutex>
#include <set>

namespace fde::bench {

const std::string* stored_quantity(std::string_view id) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> ids;
  const std::scoped_lock lock(mutex);
  const auto found = ids.find(id);
  return found == ids.end() ? &*ids.emplace(id).first : &*found;
}

}  // namespace fde::bench
