// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/recorded_run.hpp"

namespace fde::bench {

void RecordedRun::add(const Record& row) {
  if (is_time(row)) {
    if (!ending_) return;
    if (row.quantity == "time_minimum") ++timings_;
    wall_clock_ = row.wall_clock;
  } else if (ending_) {
    *this = {};
  }
  if (row.ending) {
    ending_ = row.ending->kind;
  } else {
    values_[row.quantity] = row.value;
  }
}

RecordedAmount RecordedRun::amount() const {
  if (!ending_) return RecordedAmount::nothing;
  return timings_ > 0 || !is_compared(*ending_) ? RecordedAmount::everything : RecordedAmount::all_but_times;
}

std::optional<double> RecordedRun::operator[](std::string_view quantity) const {
  const auto found = values_.find(quantity);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace fde::bench
