// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// What is recorded of a run; a run that did not finish has no times, and everything else is then
// `everything`.
enum class RecordedAmount { nothing, all_but_times, everything };

// Collects the recorded rows of one run, in file order. A time without an examination, the trace of a failed
// sweep, is ignored; another examination replaces the earlier rows.
class RecordedRun {
 public:
  void add(const Record& row);

  [[nodiscard]] RecordedAmount amount() const;

  // How the run ended; nullopt: not examined.
  [[nodiscard]] std::optional<OutcomeKind> ending() const { return ending_; }

  // Whether the times are those of whole processes.
  [[nodiscard]] bool wall_clock() const { return wall_clock_; }

  // How often the examined run has been timed, and whether other work disturbed the last of the timings.
  [[nodiscard]] int timings() const { return timings_; }
  [[nodiscard]] bool is_disturbed() const { return (*this)["disturbed"].value_or(0.0) > 0.0; }

  // The value of a quantity; nullopt: not measured.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const;

 private:
  std::optional<OutcomeKind> ending_{};
  int timings_ = 0;
  bool wall_clock_ = false;
  std::map<std::string, double, std::less<>> values_{};  // by quantity
};

}  // namespace fde::bench
