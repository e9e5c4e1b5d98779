// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/checksum.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace fde::bench {

namespace {

void require_done(int done) {
  if (done != 1) throw std::runtime_error("OpenSSL cannot compute SHA-256");
}

}  // namespace

struct Sha256::Context {
  Context() { require_done(EVP_DigestInit_ex(own.get(), EVP_sha256(), nullptr)); }
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> own{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {}
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  require_done(EVP_DigestUpdate(context_->own.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digest() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  require_done(EVP_DigestFinal_ex(context_->own.get(), digest.data(), &size));
  return fmt::format("{:02x}", fmt::join(digest.begin(), digest.begin() + size, ""));
}

std::string sha256(std::string_view bytes) {
  Sha256 sum;
  sum.add(bytes);
  return sum.digest();
}

std::string write_checksums(const Checksums& checksums) {
  std::string text;
  for (const auto& [file, digest] : checksums) text += fmt::format("{}  {}\n", digest, file);
  return text;
}

Checksums parse_checksums(const std::string& name, std::string_view text) {
  constexpr std::size_t digest_size = 64, name_at = digest_size + 2;
  Checksums checksums;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    auto line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto digest = line.substr(0, std::min(digest_size, line.size()));
    const auto between = line.substr(digest.size(), 2);
    if (digest.size() != digest_size || (between != "  " && between != " *") || line.size() <= name_at ||
        digest.find_first_not_of("0123456789abcdefABCDEF") != std::string_view::npos) {
      throw std::invalid_argument(
          fmt::format("{}: line {} must be a SHA-256 in hexadecimal, two spaces and a file", name, number));
    }
    std::string lower(digest);
    std::ranges::transform(digest, lower.begin(), [](char c) {
      return static_cast<char>(c >= 'A' && c <= 'F' ? c + 'a' - 'A' : c);
    });
    checksums[std::string(line.substr(name_at))] = lower;
  }
  return checksums;
}

}  // namespace fde::bench
