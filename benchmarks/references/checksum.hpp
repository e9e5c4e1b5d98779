// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace fde::bench {

// SHA-256 of the bytes, as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

// The same, incrementally.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256& operator=(Sha256&&) = delete;

  void add(std::string_view bytes);
  // The digest of all added bytes; nothing may be added afterwards.
  std::string digest();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

// The lines of a SHA256SUMS file as `sha256sum` writes them: digests by file name.
using Checksums = std::map<std::string, std::string>;
std::string write_checksums(const Checksums& checksums);

// Throws std::invalid_argument naming the file and an invalid line.
Checksums parse_checksums(const std::string& name, std::string_view text);

}  // namespace fde::bench
