// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/requests/sweep_request.hpp"
#include "fdebench/benchmarks/sweep/sweep_event.hpp"

namespace fde::bench {

class ResultsFile;

// Callbacks of a sweep, called by one thread at a time: with its progress, with each run that is examined,
// and first with a warning where lines of the results file are left out.
struct SweepListener {
  std::function<void(const SweepEvent&)> on_event{};
  std::function<void(const Record&)> on_run{};
  std::function<void(const std::string&)> warn{};
};

// Makes the runs of the sweeps that the file does not have, and appends them to it. Throws NumericalFailure
// at the end if a line could not be read back, with the first of these; they are not in the file.
void run_into(ResultsFile& file, std::span<const Sweep> sweeps, const SweepListener& listener = {});

// The same for a request and the path of a results file, which is made where it is missing. Returns the runs
// of the request, those of a scene side by side, the scenes of a sweep in the order of the request. A run
// that the file has is returned without measures that it lacks. Several threads examine runs: they call the
// caller's schemes and measures at the same time. Throws Refusal as sweeps_of() does, and
// std::invalid_argument naming a file that is no results file.
std::vector<Record> sweep(const SweepRequest& request, const std::filesystem::path& results,
                          const SweepListener& listener = {});

// The same without a file: all runs are made.
std::vector<Record> sweep(const SweepRequest& request, const SweepListener& listener = {});

}  // namespace fde::bench
