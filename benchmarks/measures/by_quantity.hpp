// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fde::bench {

// The id of a quantity, which is stored once for the whole process.
const std::string* stored_quantity(std::string_view id);

// What is known of a run by quantity. A run has about thirty: a list of them takes a small part of the memory
// of a tree and is searched as fast.
template <class T>
class ByQuantity {
  using List = std::vector<std::pair<const std::string*, T>>;

 public:
  class Iterator {
   public:
    explicit Iterator(typename List::const_iterator place) : place_(place) {}
    std::pair<std::string_view, const T&> operator*() const { return {*place_->first, place_->second}; }
    Iterator& operator++() {
      ++place_;
      return *this;
    }
    bool operator==(const Iterator&) const = default;

   private:
    typename List::const_iterator place_;
  };

  // Adds or replaces the value of a quantity.
  void set(std::string_view quantity, T value) {
    if (const auto found = place(quantity); found != values_.end()) {
      found->second = std::move(value);
    } else {
      values_.emplace_back(stored_quantity(quantity), std::move(value));
    }
  }

  void erase(std::string_view quantity) {
    if (const auto found = place(quantity); found != values_.end()) values_.erase(found);
  }

  // The value of a quantity; nullptr: it has none.
  [[nodiscard]] const T* find(std::string_view quantity) const {
    const auto found = std::ranges::find_if(values_, is(quantity));
    return found == values_.end() ? nullptr : &found->second;
  }

  // The quantities with their values, in the order in which they were set.
  [[nodiscard]] Iterator begin() const { return Iterator(values_.begin()); }
  [[nodiscard]] Iterator end() const { return Iterator(values_.end()); }
  [[nodiscard]] bool empty() const { return values_.empty(); }

  // Gives back memory that was reserved for more quantities.
  void shrink() { values_.shrink_to_fit(); }

  bool operator==(const ByQuantity&) const = default;

 private:
  static auto is(std::string_view quantity) {
    return [quantity](const auto& value) { return *value.first == quantity; };
  }
  auto place(std::string_view quantity) { return std::ranges::find_if(values_, is(quantity)); }

  List values_{};
};

class QuantityValues : public ByQuantity<double> {
 public:
  // nullopt: the quantity has no value.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const {
    const double* const value = find(quantity);
    return value != nullptr ? std::optional(*value) : std::nullopt;
  }
};

}  // namespace fde::bench
