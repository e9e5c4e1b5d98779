// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {

// What a call refuses, with its fields as <field>; empty if it accepts all.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const Refusal& refusal) {
    return refusal.said([](const std::string& field) { return '<' + field + '>'; }).what();
  }
  return "";
}

}  // namespace fde::bench
