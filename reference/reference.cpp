// SPDX-License-Identifier: MIT
#include "fdebench/reference/reference.hpp"

#include <utility>

namespace fde::reference {

Reference with_difference(Reference one, Reference other) {
  if (!one.at || !other.at) return {};
  Reference both{.at = {}, .evidence = one.evidence, .seconds = one.seconds, .zeros = one.zeros};
  if (both.seconds && other.seconds) *both.seconds += *other.seconds;
  both.at = [one = std::move(one.at), other = std::move(other.at)](double t) -> ReferenceValue {
    auto [value, bound] = one(t);
    const ReferenceValue second = other(t);
    bound += second.bound + (value - second.value).cwiseAbs();
    return {std::move(value), std::move(bound)};
  };
  return both;
}

}  // namespace fde::reference
