// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fde::bench {

// The first 128 bits of the SHA-256 of a text, in place of the text itself: two of n different texts have the
// same with a probability below n^2 / 1e38.
using Digest = std::array<std::uint64_t, 2>;
Digest digest_of(std::string_view text);

// Any part of a digest is a hash.
struct DigestHash {
  std::size_t operator()(const Digest& digest) const noexcept { return digest[0]; }
};

}  // namespace fde::bench
