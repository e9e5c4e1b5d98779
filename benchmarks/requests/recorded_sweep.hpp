// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/requests/sweep_request.hpp"

namespace fde::bench {

class ResultsFile;
struct SweepEvent;

// What is told of a sweep while it lasts: its progress, and each run that is examined.
struct SweepListener {
  std::function<void(const SweepEvent&)> on_event{};
  std::function<void(const Record&)> on_run{};
};

// Makes the runs of the sweeps that the file does not have, and appends them to it. Throws NumericalFailure
// at the end if a line could not be read back, with the first of these; they are not in the file.
void run_into(ResultsFile& file, std::span<const Sweep> sweeps, const SweepListener& listener = {});

// The same for a request and the path of a results file, which is made where it is missing. Returns the runs
// of the request, in the order in which the sweep asks for them: those of the file as it has them, without
// measures that it lacks. Throws Refusal as sweeps_of() does, and std::invalid_argument naming a file that is
// no results file.
std::vector<Record> sweep(const SweepRequest& request, const std::filesystem::path& results,
                          const SweepListener& listener = {});

// The same without a file: all runs are made.
std::vector<Record> sweep(const SweepRequest& request, const SweepListener& listener = {});

}  // namespace fde::bench
