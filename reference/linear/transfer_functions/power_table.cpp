// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/power_table.hpp"

namespace fde::reference {

PowerTable::PowerTable() {
  using Made = Entry::Method;
  for (const auto& [exponent, made] :
       {std::pair{0, Made::one}, std::pair{1, Made::identity}, std::pair{-1, Made::inverse}}) {
    places_.emplace(exponent, entries_.size());
    entries_.push_back({.exponent = exponent, .method = made, .fixed = exponent == -1 ? 2.0 : 0.0});
  }
}

PowerTable::Entry PowerTable::cheapest_entry(const Rational& exponent) const {
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    const auto other = places_.find(Rational(exponent - entries_[i].exponent));
    if (other == places_.end()) continue;
    const Entry &left = entries_[i], &right = entries_[other->second];
    return {.exponent = exponent,
            .method = Entry::Method::product,
            .left = i,
            .right = other->second,
            .fixed = left.fixed + right.fixed + 1.5,
            .growing = left.growing + right.growing};
  }
  return {.exponent = exponent,
          .method = Entry::Method::exponential,
          .fixed = 1.5,
          .growing = 1.5 * std::abs(exponent.convert_to<double>())};
}

std::size_t PowerTable::index(const Rational& exponent) {
  const auto [place, is_new] = places_.try_emplace(exponent, entries_.size());
  if (is_new) entries_.push_back(cheapest_entry(exponent));
  return place->second;
}

}  // namespace fde::reference
