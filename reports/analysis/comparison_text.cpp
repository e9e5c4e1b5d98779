// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/reports/analysis/comparison.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_rows = 20;  // per table

std::string label(const CommonRun& run, const LineNames& names) {
  const RunKey& key = run.now->key;
  return fmt::format("{} {} {}", label_of(key.scene), names.name(key.scheme, key.settings),
                     key.external ? fmt::format("{} rows", run.now->steps) : resolution_text(key.settings));
}

// A heading and the first rows, each followed by the name of its run.
template <typename Row>
std::string table(const std::string& heading, const std::vector<Row>& rows, const LineNames& names,
                  std::string (*text)(const Row&)) {
  if (rows.empty()) return fmt::format("{}: none\n", heading);
  std::string lines = fmt::format("{}: {}\n", heading, rows.size());
  for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i)
    lines += fmt::format("  {}  {}\n", text(rows[i]), label(rows[i].run, names));
  if (rows.size() > most_rows) lines += fmt::format("  ... and {} more\n", rows.size() - most_rows);
  return lines;
}

std::string ending_text(const EndingChange& change) {
  const auto words = [](const Record& run, const TrialResult& verdict) {
    return fmt::format("{} ({})", verdict.word, sentence(run.ending));
  };
  return fmt::format("{:<7}  {} -> {} :", change.is_worse() ? "worse" : "changed",
                     words(*change.run.before, change.before), words(*change.run.now, change.now));
}

std::string error_change_text(const ErrorChange& error) {
  const auto factor = error.before > 0.0 ? fmt::format("x {:.3g}", error.now / error.before) : "from 0";
  return fmt::format("{:<4}  {:>10}  {:>8} -> {:>8}  {:<14}", error.grew() ? "grew" : "fell", factor,
                     error_text(error.before), error_text(error.now), error.quantity);
}

std::string ratio_text(double ratio, double low, double high) {
  return fmt::format("x {:.3g} ({:.3g} to {:.3g})", ratio, low, high);
}

std::string time_change_text(const TimeRatio& time) {
  return fmt::format("{:<6}  {:<28}  {:>8} -> {:>8}", time.slower() ? "slower" : "faster",
                     ratio_text(time.ratio, time.low, time.high), time_text(time.before.median),
                     time_text(time.now.median));
}

std::string sum_of_times(const std::vector<TimeRatio>& times) {
  MedianInterval before, now;
  double logarithms = 0.0;
  const auto add = [](MedianInterval& sum, const MedianInterval& time) {
    sum.median += time.median;
    sum.low += time.low;
    sum.high += time.high;
  };
  for (const TimeRatio& time : times) {
    add(before, time.before);
    add(now, time.now);
    logarithms += std::log(time.ratio);
  }
  if (times.empty()) return "no run was timed in both\n";
  return fmt::format("time of {} runs: {} -> {}, {}; geometric mean x {:.3g}\n", times.size(),
                     time_text(before.median), time_text(now.median),
                     ratio_text(now.median / before.median, now.low / before.high, now.high / before.low),
                     std::exp(logarithms / static_cast<double>(times.size())));
}

}  // namespace

std::string comparison_text(const Comparison& comparison, const LineNames& names) {
  const auto& [common, only_before, only_now, timed_before, unlike, times, errors, endings] = comparison;
  std::vector<TimeRatio> beyond_noise;
  std::ranges::copy_if(times, std::back_inserter(beyond_noise),
                       [](const TimeRatio& time) { return time.slower() || time.faster(); });
  const auto grew = std::ranges::count_if(errors, &ErrorChange::grew);
  const auto worse = std::ranges::count_if(endings, &EndingChange::is_worse);
  const auto slower = std::ranges::count_if(times, &TimeRatio::slower);
  const auto faster = std::ranges::count_if(times, &TimeRatio::faster);
  return table("verdicts and endings that changed", endings, names, ending_text) +
         table("errors that moved", errors, names, error_change_text) +
         table("times that moved, with the spread of their repeats", beyond_noise, names, time_change_text) +
         fmt::format("{} runs in both, {} only in the first, {} only in the second\n", common, only_before,
                     only_now) +
         (timed_before == 0 ? ""
                            : fmt::format("{} runs in both are timed in the first only\n", timed_before)) +
         (unlike == 0
              ? ""
              : fmt::format("{} runs have errors over other columns in each file: not compared\n", unlike)) +
         fmt::format("verdicts: {} worse, {} changed otherwise\n", worse, std::ssize(endings) - worse) +
         fmt::format("errors: {} grew, {} fell\n", grew, std::ssize(errors) - grew) +
         fmt::format("times: {} slower, {} faster, {} within the spread of their repeats\n", slower, faster,
                     std::ssize(times) - slower - faster) +
         sum_of_times(times);
}

}  // namespace fde::bench
