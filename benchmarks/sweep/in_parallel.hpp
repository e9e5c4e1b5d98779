// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace fde::bench {

// The number of processors that this process may use: a scheduler may have given it some of the machine's.
unsigned usable_cores();

// Calls task(0), ..., task(count - 1), each once, on up to `threads` threads, of which the caller is one.
// After a task throws, also what a progress callback of the caller throws, no new task starts, and those of
// other threads are cancelled where they report progress; the first exception is rethrown when all have
// ended.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

}  // namespace fde::bench
