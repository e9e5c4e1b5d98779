// SPDX-License-Identifier: MIT
#pragma once

#include <set>

namespace fde {

// Adds up the seconds of a processor that the tables of solves took to compute: start weights and collocation
// rules, which a process computes once and retains. While this object exists, each table that a solve of this
// thread uses counts once, also where an earlier solve computed it. So the sum is by how much the first solve
// of a process takes longer than a later one. Objects of a thread must be destroyed in reverse order of
// construction; only the newest counts.
class SetupTime {
 public:
  SetupTime();
  ~SetupTime();
  SetupTime& operator=(SetupTime&&) = delete;

  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  friend void count_table(const void* table, double seconds);
  double seconds_ = 0.0;
  std::set<const void*> counted_{};
  SetupTime* outer_;
};

// Counts a retained table that took `seconds` to compute. To be called wherever a solve uses one.
void count_table(const void* table, double seconds);

// Seconds of a processor that this thread has used.
double thread_seconds();

}  // namespace fde
