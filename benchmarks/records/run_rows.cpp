// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/run_rows.hpp"

#include <string>

#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde::bench {
namespace {

Record with_value(Record row, const MeasuredValue& measured) {
  row.quantity = std::string(measured.id);
  row.value = measured.value;
  row.unit = std::string(measured.unit);
  row.course = measured.course;
  return row;
}

}  // namespace

std::vector<Record> rows_of_examination(const Record& run, const Assessment& judgement) {
  std::vector<Record> rows;
  for (const auto& measured : judgement.measured) rows.push_back(with_value(run, measured));
  rows.push_back(with_value(run, {"ending", "t", judgement.end_time}));
  rows.back().ending = judgement.ending;
  rows.back().columns = judgement.columns;
  return rows;
}

std::vector<Record> rows_of_times(const Record& run, const TimedSolves& timed) {
  std::vector<Record> rows;
  for (const auto& measure : time_measures()) {
    if (const auto value = measure.value(timed))
      rows.push_back(with_value(run, {measure.id, measure.unit, *value}));
  }
  return rows;
}

}  // namespace fde::bench
