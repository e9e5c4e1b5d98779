// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fde::bench {

// A quantity as a function of time, at increasing times.
struct Course {
  std::vector<double> t{}, value{};

  [[nodiscard]] bool empty() const { return t.empty(); }
  bool operator==(const Course&) const = default;
};

// The largest value up to t as a function of t, for charts: at eight times per factor of 2, from end/1024 on,
// to three digits. A time at which no value was positive is left out.
class RunningMaximum {
 public:
  explicit RunningMaximum(double end);

  // Times must increase.
  void observe(double t, double value);

  [[nodiscard]] const Course& course() const { return course_; }

 private:
  void add(double t, double value);

  double next_, largest_ = 0.0;
  Course course_{};
};

}  // namespace fde::bench
