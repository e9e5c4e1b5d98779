// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/packed.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <limits>
#include <new>
#include <stdexcept>
#include <vector>

namespace fde::bench {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr int gzip = 16;  // added to the logarithm of the window's size
constexpr int most_memory = 9;
constexpr std::size_t longest_text =
    std::numeric_limits<int>::max() / 2;  // of zlib, OpenSSL and their results

// const_cast: zlib's input is not const for historical reasons, and is not changed.
Bytes compressed(std::string_view text) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzip, most_memory,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  Bytes result(deflateBound(&stream, text.size()));
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = result.data();
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);  // ends at once: there is room for everything
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

}  // namespace

std::string packed(std::string_view text) {
  if (text.size() > longest_text) throw std::length_error("report: the results are too many for one page");
  const Bytes bytes = compressed(text);
  constexpr std::size_t group = 3, letters = 4;
  // OpenSSL writes a zero byte after the letters, where std::string has one.
  std::string result((bytes.size() + group - 1) / group * letters, '\0');
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(result.data()), bytes.data(),
                  static_cast<int>(bytes.size()));
  return result;
}

}  // namespace fde::bench
