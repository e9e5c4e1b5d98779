#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "records/record.hpp"
#include "scenes/registry.hpp"

namespace fde {

// Who hears what a results file holds, in its order.
struct ResultsHearing {
  std::function<void(const Session&, std::uint64_t rows_begin)> session;  // the byte at which its rows begin
  std::function<void(std::vector<Record> rows, std::uint64_t rows_end)> rows;  // of one write
};

// Reads a results file line by line: JSON lines, a session or a record each. Incomplete last rows, left by a
// killed sweep, are passed over. Returns the bytes up to the end of the last complete write. Records of a
// session have its number, from 0. Throws std::invalid_argument naming the file, and the line where there is
// one, when it cannot be read, was written by another version with rows of another form, has a row that none
// can have, or is something else. Scenes must be among those known.
std::uint64_t scan_results(const std::filesystem::path& file, const ResultsHearing& hearing,
                           const Scenes& known = scenes());

}  // namespace fde
