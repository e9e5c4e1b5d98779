// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/digest.hpp"

#include <openssl/evp.h>

#include <cstring>
#include <stdexcept>

namespace fde::bench {

Digest digest_of(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  if (EVP_Digest(text.data(), text.size(), bytes.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  Digest digest{};
  std::memcpy(digest.data(), bytes.data(), sizeof(digest));
  return digest;
}

}  // namespace fde::bench
