// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fde {

// How the memory terms of a run are evaluated: with all samples, or with a sum of exponentials in place of
// the weights. automatic: the faster one by an estimate of their costs.
enum class HistoryKind { automatic, direct, exponentials };

// "auto", "direct", "exponentials".
std::string_view name(HistoryKind kind);

}  // namespace fde
