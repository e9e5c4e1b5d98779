// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/parallel_for_rows.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace fde {
namespace {

constexpr Eigen::Index rows_of_a_part = 2048;         // about ten such columns fit into a cache of 256 KB
constexpr Eigen::Index fewest_rows_to_share = 16384;  // fewer rows take as long as waking a thread
constexpr int looks = 400;                            // before a thread sleeps: some microseconds

thread_local RowThreads* innermost = nullptr;

// Waits until value is no longer `old`. A thread that sleeps takes longer to wake than a short loop takes.
template <typename Value>
void wait_while(const std::atomic<Value>& value, Value old) {
  for (int look = 0; look < looks; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

// A thread of its own for each worker but the first, which is the caller of run().
class RowThreads::Team {
 public:
  using Work = std::function<void(Eigen::Index part)>;

  explicit Team(int workers) : ranges_(static_cast<std::size_t>(workers)) {
    try {
      for (std::size_t worker = 1; worker < ranges_.size(); ++worker)
        others_.emplace_back([this, worker] { serve(worker); });
    } catch (const std::system_error&) {
      // The threads that the system grants take the parts of the others.
    }
  }
  ~Team() {
    ending_ = true;
    begin_round();
    for (auto& other : others_) other.join();
  }
  Team& operator=(Team&&) = delete;

  // Calls work(part) for all parts.
  void run(Eigen::Index parts, const Work& work) {
    work_ = &work;
    Eigen::Index worker = 0;
    for (auto& range : ranges_) {
      range.next = parts * worker / std::ssize(ranges_);
      range.end = parts * ++worker / std::ssize(ranges_);
    }
    working_ = std::ssize(others_);
    begin_round();
    work_on(0);
    for (auto left = working_.load(); left > 0; left = working_.load()) wait_while(working_, left);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }

 private:
  // The parts of one worker. Others take from them when they have none left.
  struct alignas(64) Range {
    std::atomic<Eigen::Index> next{0};
    Eigen::Index end = 0;
  };

  void begin_round() {
    ++round_;
    round_.notify_all();
  }

  void serve(std::size_t worker) {
    for (unsigned round = 0;; ++round) {
      wait_while(round_, round);
      if (ending_) return;
      work_on(worker);
      --working_;
      working_.notify_one();
    }
  }

  void work_on(std::size_t worker) {
    try {
      for (std::size_t i = 0; i < ranges_.size(); ++i) {
        auto& range = ranges_[(worker + i) % ranges_.size()];
        for (auto part = range.next++; part < range.end; part = range.next++) (*work_)(part);
      }
    } catch (...) {
      const std::scoped_lock lock(error_lock_);
      error_ = std::current_exception();
    }
  }

  std::vector<Range> ranges_;  // of each worker
  const Work* work_ = nullptr;
  std::atomic<unsigned> round_{0};
  std::atomic<std::ptrdiff_t> working_{0};  // workers other than the first that have not ended this round
  bool ending_ = false;
  std::mutex error_lock_;
  std::exception_ptr error_;
  std::vector<std::thread> others_;
};

RowThreads::RowThreads(int threads)
    : team_(threads > 1 ? std::make_unique<Team>(threads) : nullptr), outer_(innermost) {
  innermost = this;
}

RowThreads::~RowThreads() { innermost = outer_; }

void parallel_for_parts(Eigen::Index parts, Eigen::Index rows_of_part,
                        const std::function<void(Eigen::Index part)>& work) {
  auto* const team = innermost != nullptr ? innermost->team_.get() : nullptr;
  if (team != nullptr && parts > 1 && parts * rows_of_part >= fewest_rows_to_share) {
    const RowThreads within_a_part(1);
    team->run(parts, work);
  } else {
    for (Eigen::Index part = 0; part < parts; ++part) work(part);
  }
}

void parallel_for_rows(Eigen::Index rows, Eigen::Index unit,
                       const std::function<void(Eigen::Index first, Eigen::Index count)>& work) {
  const Eigen::Index of_part = std::max(rows_of_a_part / unit, Eigen::Index{1}) * unit;
  const auto work_on = [&](Eigen::Index part) {
    work(part * of_part, std::min(of_part, rows - part * of_part));
  };
  parallel_for_parts((rows + of_part - 1) / of_part, of_part, work_on);
}

}  // namespace fde
