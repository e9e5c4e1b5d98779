#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "records/record.hpp"

namespace fde {

// What is recorded of a run: nothing, all but its times, everything (a run that did not finish has no times).
enum class Recorded { nothing, all_but_times, everything };

// The recorded rows of one run, one after the other. A time without an examination, as a fault of a sweep
// would leave it, does not count; another examination begins the run again.
class RecordedRun {
 public:
  void note(const Record& row);

  [[nodiscard]] Recorded amount() const;

  // How it ended; nullopt: it is not examined.
  [[nodiscard]] std::optional<Ending> ending() const { return ending_; }

  // Whether its times are of whole processes.
  [[nodiscard]] bool wall_clock() const { return wall_clock_; }

  // The value of a quantity; nullopt: not measured.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const;

 private:
  std::optional<Ending> ending_{};
  bool timed_ = false, wall_clock_ = false;
  std::map<std::string, double, std::less<>> values_{};  // by quantity
};

}  // namespace fde
