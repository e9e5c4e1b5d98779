// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "fdebench/benchmarks/files/lines_by_offset.hpp"
#include "fdebench/benchmarks/records/digest.hpp"
#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// Where a results file has a run: some thirty bytes in place of a Record of thousands. Sessions are counted
// as by ResultsReader.
struct PlacedRun {
  std::uint64_t examination = 0;  // offset of its line
  std::uint64_t times = 0;        // offset of the line of the last later times; 0: none
  std::uint32_t session = 0, session_of_times = 0;
  std::int32_t later_timings = 0;  // the number of lines of later times
  bool has_own_times = true;       // whether the times in the line of the examination count

  void take_times(std::uint64_t offset, std::size_t session_of_line) {
    times = offset;
    session_of_times = static_cast<std::uint32_t>(session_of_line);
    ++later_timings;
  }
};

// Reads the record in its place. Throws as LinesByOffset and parse_line do if the file has been changed.
Record read_record(const LinesByOffset& file, const PlacedRun& place);

// The digest of the key as text.
Digest digest_of(const RunKey& run);

}  // namespace fde::bench
