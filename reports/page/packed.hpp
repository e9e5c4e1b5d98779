// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fde::bench {

// The text as gzip in base64, without line breaks. Equal texts give equal bytes: the header of gzip has
// neither a time nor a name. The page unpacks it (unpacked.js).
std::string packed(std::string_view text);

}  // namespace fde::bench
