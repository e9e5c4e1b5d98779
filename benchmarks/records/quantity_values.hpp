// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace fde::bench {

// The values of a run by quantity. A run has about thirty: a list of them takes a quarter of the memory of a
// tree and is searched as fast. The ids of quantities are stored once for the whole process.
class QuantityValues {
 public:
  // Adds or replaces the value of a quantity.
  void set(std::string_view quantity, double value);

  void erase(std::string_view quantity);

  // The value of a quantity; nullopt: it has none.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const;

  // The quantities with their values, in the order in which they were set.
  using Value = std::pair<std::string_view, double>;
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }

  bool operator==(const QuantityValues&) const = default;

 private:
  std::vector<Value> values_{};
};

}  // namespace fde::bench
