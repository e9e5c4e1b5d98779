// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <limits>

#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

namespace fde::bench::c {
namespace {

// The fact of this name, null or accepted by `fits`.
template <typename Fits>
const nlohmann::json& fact_in(const nlohmann::json& facts, const std::string& name, const Fits& fits) {
  const auto found = facts.find(name);
  if (found != facts.end() && (found->is_null() || fits(*found))) return *found;
  std::vector<std::string> names;
  for (const auto& [known, value] : facts.items()) {
    if (value.is_null() || fits(value)) names.push_back(known);
  }
  throw std::invalid_argument(fmt::format("fact = {}: must be of {}", name, fmt::join(names, ", ")));
}

}  // namespace

double number_in(const nlohmann::json& facts, const std::string& name) {
  const auto& fact = fact_in(facts, name, [](const auto& value) { return value.is_number(); });
  return fact.is_null() ? std::numeric_limits<double>::quiet_NaN() : fact.template get<double>();
}

const char* text_in(const nlohmann::json& facts, const std::string& name) {
  const auto& fact = fact_in(facts, name, [](const auto& value) { return value.is_string(); });
  return fact.is_null() ? "" : fact.template get_ref<const std::string&>().c_str();
}

}  // namespace fde::bench::c
