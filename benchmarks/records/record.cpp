// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/record.hpp"

#include <tuple>
#include <utility>

#include "fdebench/benchmarks/measures/judge.hpp"
#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde::bench {

Timing timing_of(const TimedSolves& timed) {
  Timing timing{.count = 1};
  for (const auto& measure : time_measures())
    if (const auto value = measure.value(timed)) timing.values.set(measure.id, *value);
  return timing;
}

Record assessed(Record run, const Assessment& judgement) {
  Record found{.key = std::move(run.key),
               .steps = run.steps,
               .end = run.end,
               .ending = judgement.ending,
               .ended_at = judgement.end_time,
               .program = std::move(run.program),
               .columns = judgement.columns};
  for (const auto& measured : judgement.measured) {
    found.values.set(measured.id, measured.value);
    if (!measured.course.empty()) found.courses.emplace(measured.id, measured.course);
  }
  return found;
}

std::optional<double> Record::operator[](std::string_view quantity) const {
  const auto value = values[quantity];
  return value ? value : timing.values[quantity];
}

void Record::take(Timing later) {
  later.count += timing.count;
  timing = std::move(later);
}

bool Record::is_complete() const { return !timing.values.empty() || !is_compared(ending.kind); }

bool same_build(const Session& a, const Session& b) {
  const auto facts = [](const Session& s) { return std::tie(s.compiler, s.flags, s.commit, s.version); };
  return facts(a) == facts(b);
}

bool same_machine(const Session& a, const Session& b) { return a.machine == b.machine; }

}  // namespace fde::bench
