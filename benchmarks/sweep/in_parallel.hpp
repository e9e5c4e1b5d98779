#pragma once

#include <cstddef>
#include <functional>

namespace fde {

// Calls task(0), ..., task(count - 1), each once, on that many threads. After a failure no new task starts;
// the first one is thrown again when all threads have ended.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

}  // namespace fde
