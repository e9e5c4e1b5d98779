// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <memory>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// While this object exists, the functions below share their work among `threads` threads if they are called
// by this thread. The threads wait between the calls. The innermost object counts. Objects of a thread must
// be destroyed in reverse order of construction.
class RowThreads {
 public:
  explicit RowThreads(int threads);
  ~RowThreads();
  RowThreads& operator=(RowThreads&&) = delete;

 private:
  class Team;
  friend void parallel_for_parts(Eigen::Index parts, Eigen::Index rows_of_part,
                                 const std::function<void(Eigen::Index part)>& work);
  std::unique_ptr<Team> team_;  // nullptr: one thread
  RowThreads* outer_;
};

// Calls work(part) for part = 0 ... parts - 1, each of some rows_of_part rows. Each thread begins with
// neighbouring parts and goes on with parts that others have not begun; few rows are processed by one thread.
// Precondition: work writes to its own part only, so the result does not depend on the number of threads.
// Rethrows an exception of a part after all threads have ended.
void parallel_for_parts(Eigen::Index parts, Eigen::Index rows_of_part,
                        const std::function<void(Eigen::Index part)>& work);

// The same for parts work(first, count) that partition `rows` rows. Their sizes are multiples of `unit`,
// except the last, and fit into the cache.
void parallel_for_rows(Eigen::Index rows, Eigen::Index unit,
                       const std::function<void(Eigen::Index first, Eigen::Index count)>& work);

// Fewer rows are processed by the calling thread, without vectors.
inline constexpr Eigen::Index few_rows = 64;

// Calls body(i) for each row i, in any order; few rows as for_each_component, many with vectors.
// Precondition: body writes to its own row only.
template <typename Body>
void for_each_row(Eigen::Index rows, Body body) {
  if (rows < few_rows) return for_each_component(rows, body);
  parallel_for_rows(rows, 1, [&](Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index i = first; i < first + count; ++i) body(i);
  });
}

// to = from, for arrays of `rows` rows.
inline void copy_rows(Eigen::Index rows, const double* from, double* to) {
  for_each_row(rows, [=](Eigen::Index i) { to[i] = from[i]; });
}

// Whether holds(i) for each row i. All rows are looked at.
template <typename Predicate>
bool holds_for_each_row(Eigen::Index rows, Predicate holds) {
  if (rows < few_rows) {
    Eigen::Index failures = 0;
    for_each_component(rows, [&](Eigen::Index i) { failures += holds(i) ? 0 : 1; });
    return failures == 0;
  }
  std::atomic<bool> all = true;
  parallel_for_rows(rows, 1, [&](Eigen::Index first, Eigen::Index count) {
    Eigen::Index failures = 0;  // a sum, because compilers do not vectorise a conjunction
    for (Eigen::Index i = first; i < first + count; ++i) failures += holds(i) ? 0 : 1;
    if (failures > 0) all = false;
  });
  return all;
}

}  // namespace fde
