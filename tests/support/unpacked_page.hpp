// SPDX-License-Identifier: MIT
#pragma once

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace fde::bench {

// What an element of a page of `fdebench report` contains as gzip in base64.
inline std::string unpacked(const std::string& page, const std::string& id) {
  const std::string open = R"(<script type="application/gzip" id=")" + id + "\">";
  const auto start = page.find(open) + open.size();
  const std::string letters = page.substr(start, page.find("</script>", start) - start);
  std::vector<unsigned char> bytes(letters.size());
  const int size = EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(letters.data()),
                                   static_cast<int>(letters.size()));
  if (size < 0) throw std::runtime_error("not base64");
  bytes.resize(static_cast<std::size_t>(size - std::ranges::count(letters, '=')));
  z_stream stream{};
  inflateInit2(&stream, MAX_WBITS + 16);  // gzip
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  int state = Z_OK;
  while (state == Z_OK) {
    std::string piece(1U << 20U, '\0');
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text += piece.substr(0, piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || stream.avail_in > 0) throw std::runtime_error("not one stream of gzip");
  return text;
}

}  // namespace fde::bench
