// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/in_parallel.hpp"

#include <mpfr.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::bench {

unsigned usable_cores() {
  cpu_set_t usable;
  CPU_ZERO(&usable);
  if (sched_getaffinity(0, sizeof usable, &usable) == 0) return static_cast<unsigned>(CPU_COUNT(&usable));
  return std::thread::hardware_concurrency();  // a machine with more processors than a set holds
}

void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (auto i = next++; i < count; i = next++) task(i);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
      has_failed = true;
    }
  };
  const auto work_until_failure = [&] {
    const ProgressScope scope([&](std::size_t, std::size_t) {
      if (has_failed) throw Cancelled();
    });
    work();
    mpfr_free_cache();  // MPFR does not free its cached constants of a thread when the thread ends
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t worker = 1; worker < std::min<std::size_t>(count, threads); ++worker)
      workers.emplace_back(work_until_failure);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace fde::bench
