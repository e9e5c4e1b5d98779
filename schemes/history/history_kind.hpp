// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fde {

// How the memory terms of a run are evaluated: with all samples, or with a sum of exponentials in place of
// the weights. automatic: the better one by an estimate of their time and memory.
enum class HistoryKind { automatic, direct, exponentials };

// "auto", "direct", "exponentials".
std::string_view name(HistoryKind kind);

// The kind of the history of a run.
struct ChosenHistory {
  HistoryKind kind = HistoryKind::direct;  // direct or exponentials
  bool for_memory = false;  // it was chosen for its memory: the other kind was estimated to be faster
};

}  // namespace fde
