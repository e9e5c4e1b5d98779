// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/refusal.hpp"

#include <fmt/format.h>

#include <utility>

namespace fde::bench {
namespace {

std::string text_of(const std::vector<Refusal::Part>& parts) {
  std::string text;
  for (const auto& part : parts) {
    const auto* field = std::get_if<RequestField>(&part);
    text += field != nullptr ? field->name : std::get<std::string>(part);
  }
  return text;
}

}  // namespace

Refusal::Refusal(std::vector<Part> parts) : std::invalid_argument(text_of(parts)), parts_(std::move(parts)) {}

std::string Refusal::field() const {
  for (const auto& part : parts_)
    if (const auto* field = std::get_if<RequestField>(&part)) return field->name;
  return "";
}

Refusal Refusal::said(const std::function<std::string(const std::string&)>& word) const {
  auto parts = parts_;
  for (auto& part : parts) {
    if (auto* field = std::get_if<RequestField>(&part)) field->name = word(field->name);
  }
  return Refusal(std::move(parts));
}

void refuse_value(std::string_view name, std::string_view value, const std::vector<Refusal::Part>& allowed) {
  std::vector<Refusal::Part> parts{RequestField{std::string(name)}, fmt::format(" = {}: must be ", value)};
  parts.insert(parts.end(), allowed.begin(), allowed.end());
  throw Refusal(std::move(parts));
}

void require_in(std::string_view name, double value, const Range& allowed) {
  if (!allowed.contains(value)) refuse_value(name, fmt::format("{}", value), {allowed.text()});
}

void require_in(std::string_view name, int value, const CountRange& allowed) {
  if (value < allowed.lowest || value > allowed.highest)
    refuse_value(name, fmt::format("{}", value), {allowed.text()});
}

}  // namespace fde::bench
