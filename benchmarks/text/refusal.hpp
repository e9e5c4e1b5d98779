// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {

// A field of a request, named in a message. Each front has its own word for it: --steps on a command line,
// steps in Python and C.
struct RequestField {
  std::string name;
};

// A request that is not accepted, for the reason that its parts say together. what() names the fields as the
// request does: "steps = 0: must be a whole number from 1 to 1000000000".
class Refusal : public std::invalid_argument {
 public:
  using Part = std::variant<std::string, RequestField>;
  explicit Refusal(std::vector<Part> parts);

  // The first field that it names; empty: none.
  [[nodiscard]] std::string field() const;

  // The same refusal with another word for each field.
  [[nodiscard]] Refusal said(const std::function<std::string(const std::string&)>& word) const;

 private:
  std::vector<Part> parts_;
};

// Throws Refusal: "NAME = VALUE: must be ALLOWED", where the allowed text may name other fields.
[[noreturn]] void refuse_value(std::string_view name, std::string_view value,
                               const std::vector<Refusal::Part>& allowed);

// Throws Refusal naming the field, its value and the range, unless the value is in the range.
void require_in(std::string_view name, double value, const Range& allowed);
void require_in(std::string_view name, int value, const CountRange& allowed);

}  // namespace fde::bench
