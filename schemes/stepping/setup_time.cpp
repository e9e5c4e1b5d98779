// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/setup_time.hpp"

#include <ctime>
#include <utility>

namespace fde {
namespace {

thread_local SetupTime* newest = nullptr;

}  // namespace

SetupTime::SetupTime() : outer_(std::exchange(newest, this)) {}

SetupTime::~SetupTime() { newest = outer_; }

void count_table(const void* table, double seconds) {
  if (newest != nullptr && newest->counted_.insert(table).second) newest->seconds_ += seconds;
}

double thread_seconds() {
  constexpr double nanosecond = 1e-9;
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + nanosecond * static_cast<double>(used.tv_nsec);
}

}  // namespace fde
