// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/external_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/files/lines.hpp"
#include "fdebench/benchmarks/measures/accuracy.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/records/well_formed.hpp"
#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_values = 10'000'000;

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return quoted ? cell.substr(1, cell.size() - 2) : cell;
}

// The names after t. np.savetxt begins the header with #, spreadsheets with a byte order mark.
std::vector<std::string> names_in(std::string_view header, const Scene& scene) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  constexpr std::size_t longest = 60;
  if (header.starts_with(byte_order_mark)) header.remove_prefix(byte_order_mark.size());
  header = trimmed(header);
  if (header.starts_with('#')) header.remove_prefix(1);
  std::vector<std::string> names;
  for (const auto& cell : split_names(header)) names.emplace_back(unquoted(trimmed(cell)));
  if (names.front() != "t") {
    throw std::invalid_argument(
        fmt::format("'{}': must be the header, t and one or more of the columns {}, with commas between them",
                    is_printable(header) ? header.substr(0, longest) : "", csv_names(scene.outputs.names)));
  }
  names.erase(names.begin());
  return names;
}

// What a cell after t has: a value or a standard deviation of a column of the scene; nullopt: it is ignored.
struct CellMeaning {
  Eigen::Index column;
  bool is_deviation;
  bool operator==(const CellMeaning&) const = default;
};
using CellMeanings = std::vector<std::optional<CellMeaning>>;

constexpr std::string_view deviation_prefix = "sd_";

std::optional<CellMeaning> meaning_of(const std::string& name, const Scene& scene) {
  const auto& own = scene.outputs.names;
  const auto index_of = [&](std::string_view wanted) {
    const auto found = std::ranges::find(own, wanted);
    return found != own.end() ? found : std::ranges::find(own, wanted, plain_name);
  };
  if (const auto found = index_of(name); found != own.end()) return CellMeaning{found - own.begin(), false};
  const auto of = name.starts_with(deviation_prefix)
                      ? index_of(std::string_view(name).substr(deviation_prefix.size()))
                      : own.end();
  if (of != own.end()) return CellMeaning{of - own.begin(), true};
  auto printed = printed_names(scene);
  std::ranges::copy(reaction_names(scene), std::back_inserter(printed));
  for (const auto& bounded : printed_names(scene)) printed.push_back(bound_column(bounded));
  printed.push_back(bound_column());
  if (std::ranges::find(printed, name) == printed.end() &&
      std::ranges::find(printed, name, plain_name) == printed.end())
    throw_unknown_id("column", name, {own.begin(), own.end()});
  return std::nullopt;
}

CellMeanings meanings_of(const std::vector<std::string>& names, const Scene& scene) {
  CellMeanings meanings;
  for (auto name = names.begin(); name != names.end(); ++name) {
    const auto meaning = meaning_of(*name, scene);
    const bool is_known = meaning && std::ranges::find(meanings, meaning) != meanings.end();
    if (is_known || std::find(names.begin(), name, *name) != name)
      throw std::invalid_argument(fmt::format("column {} occurs twice", *name));
    meanings.push_back(meaning);
  }
  return meanings;
}

class TrajectoryReader {
 public:
  TrajectoryReader(std::vector<std::string> names, const Scene& scene, TrajectorySource source)
      : names_(std::move(names)),
        meanings_(meanings_of(names_, scene)),
        end_(scene.problem.end),
        is_measured_(source == TrajectorySource::measured) {
    path_.columns = columns_with(false);
    if (path_.columns.empty()) {
      throw std::invalid_argument(
          fmt::format("has no column of the scene; they are {}", fmt::join(scene.outputs.names, ", ")));
    }
    require_all_or_no_deviations(scene);
  }

  void take(std::string_view line) {
    const auto cells = split_list(line);
    if (cells.size() != names_.size() + 1) {
      throw std::invalid_argument(
          fmt::format("must have {} cells, as the header, not {}", names_.size() + 1, cells.size()));
    }
    row_.assign(1, parse_number("t", trimmed(cells.front()), not_negative));
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const auto cell = trimmed(cells[i + 1]);
      const auto value = cell.empty() && is_measured_ ? missing : try_parse_number(cell);
      if (!value) reject_text(names_[i], cell, "a number");
      row_.push_back(*value);
    }
    take(row_);
  }

  // A time, and a number for each name.
  void take(const std::vector<double>& row) {
    take_time(row.front());
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!meanings_[i]) continue;
      const double value = row[i + 1];
      if (meanings_[i]->is_deviation && !(value > 0.0 && std::isfinite(value)) && !has_no_value(row, i))
        reject_text(names_[i], fmt::format("{}", value), positive.text());
      if (is_measured_ && !meanings_[i]->is_deviation && std::isinf(value))
        reject_text(names_[i], fmt::format("{}", value), "a finite number, or empty where it is missing");
      (meanings_[i]->is_deviation ? deviations_ : values_).push_back(value);
    }
    if (values_.size() > most_values)
      throw std::invalid_argument(fmt::format("there are more than {} values", most_values));
  }

  ExternalTrajectory path() && {
    if (path_.times.empty() || path_.times.back() == 0.0)
      throw std::invalid_argument("there is no row behind t = 0");
    const auto times = std::ssize(path_.times), columns = std::ssize(path_.columns);
    path_.values = Eigen::Map<const Matrix>(values_.data(), columns, times);
    if (deviations_.empty()) return std::move(path_);
    // The deviations of a file may be in another order than the values.
    const Eigen::Map<const Matrix> given(deviations_.data(), columns, times);
    path_.deviations.resize(columns, times);
    const auto of = columns_with(true);
    for (std::size_t i = 0; i < of.size(); ++i) {
      path_.deviations.row(std::ranges::find(path_.columns, of[i]) - path_.columns.begin()) =
          given.row(static_cast<Eigen::Index>(i));
    }
    return std::move(path_);
  }

 private:
  static constexpr std::optional<double> missing = std::numeric_limits<double>::quiet_NaN();

  // The columns of the scene whose values, or deviations, the cells have, in their order.
  [[nodiscard]] std::vector<Eigen::Index> columns_with(bool deviations) const {
    std::vector<Eigen::Index> columns;
    for (const auto& meaning : meanings_)
      if (meaning && meaning->is_deviation == deviations) columns.push_back(meaning->column);
    return columns;
  }

  void require_all_or_no_deviations(const Scene& scene) const {
    const auto with = columns_with(true);
    const auto require = [&](std::string_view prefix, Eigen::Index column, const auto& among) {
      if (std::ranges::find(among, column) != among.end()) return;
      throw std::invalid_argument(
          fmt::format("column {}{} is missing: all columns have standard deviations or none", prefix,
                      scene.outputs.names[static_cast<std::size_t>(column)]));
    };
    for (const Eigen::Index column : with) require("", column, path_.columns);
    if (with.empty()) return;
    for (const Eigen::Index column : path_.columns) require(deviation_prefix, column, with);
  }

  // Whether cell i is the deviation of a value that is missing.
  [[nodiscard]] bool has_no_value(const std::vector<double>& row, std::size_t i) const {
    const auto of = std::ranges::find(meanings_, std::optional(CellMeaning{meanings_[i]->column, false}));
    return is_measured_ && std::isnan(row[static_cast<std::size_t>(of - meanings_.begin()) + 1]);
  }

  // A time within rounding of the end is set to the end.
  void take_time(double t) {
    constexpr double rounding = 1e-12;
    const auto text = [&] { return fmt::format("{}", t); };
    if (!(t >= 0.0) || std::isinf(t)) reject_text("t", text(), not_negative.text());
    if (t > end_ * (1.0 + rounding))
      reject_text("t", text(), fmt::format("in [0, {}], as in the scene", end_));
    if (std::abs(t - end_) <= rounding * end_) t = end_;
    if (!path_.times.empty() && (is_measured_ ? t < path_.times.back() : t <= path_.times.back())) {
      reject_text(
          "t", text(),
          fmt::format("{} {}, the time before", is_measured_ ? "at least" : "above", path_.times.back()));
    }
    path_.times.push_back(t);
  }

  std::vector<std::string> names_;
  CellMeanings meanings_;
  double end_;
  bool is_measured_;
  ExternalTrajectory path_{};
  std::vector<double> values_{}, deviations_{}, row_{};  // row_: the cells of the present line
};

std::vector<double> numbers_in(std::string_view key, std::string_view text) {
  std::vector<double> numbers;
  for (auto rest = trimmed(text); !rest.empty() || numbers.empty();) {
    const auto end = std::min(rest.find_first_of(" \t"), rest.size());
    numbers.push_back(parse_number(key, rest.substr(0, end), positive));
    rest = trimmed(rest.substr(end));
  }
  return numbers;
}

// The code is the first word, its version the rest.
void set_code(ProgramFacts& facts, std::string_view text) {
  const auto space = std::min(text.find(' '), text.size());
  facts.code = text.substr(0, space);
  facts.version = trimmed(text.substr(space));
}

// Takes over one comment. Throws std::invalid_argument naming the key, the value and what is allowed.
void set(ProgramReport& report, std::string_view key, std::string_view text) {
  if (key == "seconds") {
    report.seconds = numbers_in(key, text);
  } else if (key == "first") {
    report.first = parse_number(key, text, positive);
  } else if (key == "times") {
    if (text != "own") reject_text(key, text, "own");
    report.chooses_times = true;
  } else {
    require_name(key, text);
    if (key == "code") {
      set_code(report.facts, text);
    } else {
      report.facts.language = text;
    }
  }
}

// Reads the lines `# KEY: VALUE` of a report; a line with another key is of the table.
class ReportReader {
 public:
  // Whether the line is a comment of the report.
  bool take(std::string_view line) {
    const auto colon = line.find(':');
    if (!line.starts_with("# ") || colon == std::string_view::npos) return false;
    const auto key = line.substr(2, colon - 2);
    constexpr std::array known{"code", "language", "first", "seconds", "times"};
    if (std::ranges::find(known, key) == known.end()) return false;
    if (!given_.emplace(key).second) throw std::invalid_argument(fmt::format("{} is given twice", key));
    set(report_, key, trimmed(line.substr(colon + 1)));
    return true;
  }

  [[nodiscard]] const ProgramReport& report() const { return report_; }

 private:
  std::set<std::string, std::less<>> given_{};
  ProgramReport report_{};
};

// Messages are C strings: they would end at a NUL.
void require_text(const std::string& line) {
  if (line.find('\0') != std::string::npos) throw std::invalid_argument("has a NUL byte, which no CSV has");
}

ExternalTrajectory read_lines(LineReader& line, const Scene& scene, TrajectorySource source) {
  ReportReader comments;
  bool has_header = line.next();
  while (has_header && comments.take(line.text())) has_header = line.next();
  if (!has_header) throw std::invalid_argument("there is no header");
  require_text(line.text());
  TrajectoryReader reader(names_in(line.text(), scene), scene, source);
  bool is_over = false;  // only empty lines may follow
  while (line.next()) {
    require_text(line.text());
    const bool is_empty = trimmed(line.text()).empty();
    if (is_over && !is_empty) throw std::invalid_argument("a row behind an empty line");
    is_over = is_empty;
    if (!is_empty) reader.take(line.text());
  }
  auto path = std::move(reader).path();
  path.report = comments.report();
  return path;
}

std::vector<std::string> names_of(const Scene& scene, const ExternalTrajectory& path) {
  std::vector<std::string> names;
  for (const auto column : path.columns)
    names.push_back(scene.outputs.names[static_cast<std::size_t>(column)]);
  return names;
}

// `reference` has all columns of the scene.
Assessment judge_values(const Scene& scene, const ExternalTrajectory& path, MemoizedReference& reference) {
  if (const auto gap = first_not_finite(path.values)) {
    const double t = path.times[static_cast<std::size_t>(*gap)];
    return {{SolveStatus::non_finite, at_time(std::nullopt, t)}, t};
  }
  if (std::ssize(path.columns) < std::ssize(scene.outputs.names)) {
    MemoizedReference some(scene, path.columns);
    return judge_columns(path.times, path.values, some, {}, {names_of(scene, path), true});
  }
  Rows ordered(path.values.rows(), path.values.cols());
  for (std::size_t i = 0; i < path.columns.size(); ++i)
    ordered.row(path.columns[i]) = path.values.row(static_cast<Eigen::Index>(i));
  return judge_columns(path.times, ordered, reference, {}, {scene.outputs.names});
}

}  // namespace

ExternalTrajectory read_trajectory(const std::filesystem::path& file, const Scene& scene,
                                   const std::string& name, TrajectorySource source) {
  const std::string called = name.empty() ? file.string() : name;
  LineReader line(file, called);
  try {
    return read_lines(line, scene, source);
  } catch (const std::invalid_argument& error) {
    const std::string_view what = error.what();
    if (what.starts_with(called + ":")) throw;  // already names the line
    throw std::invalid_argument(fmt::format("{}: line {}: {}", called, line.number(), what));
  }
}

ExternalTrajectory measured_trajectory(const Scene& scene, const std::vector<std::string>& names,
                                       const std::vector<std::vector<double>>& rows) {
  TrajectoryReader reader(names, scene, TrajectorySource::measured);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    try {
      reader.take(rows[i]);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("row {}: {}", i + 1, error.what()));
    }
  }
  return std::move(reader).path();
}

ProgramReport read_report(const std::filesystem::path& file) {
  ReportReader comments;
  try {
    LineReader line(file, file.string());
    while (line.next() && comments.take(line.text())) {
    }
  } catch (const std::invalid_argument&) {  // what was read before is still true
  }
  return comments.report();
}

ExternalTrajectory at_comparison_times(const ExternalTrajectory& path) {
  if (!path.values.allFinite()) return path;
  ExternalTrajectory some{.columns = path.columns, .report = path.report};
  const auto rows = comparison_steps(static_cast<int>(path.times.size()) - 1);
  for (const int row : rows) some.times.push_back(path.times[static_cast<std::size_t>(row)]);
  some.values = path.values(Eigen::all, rows);
  if (path.deviations.size() > 0) some.deviations = path.deviations(Eigen::all, rows);
  return some;
}

Assessment judge_trajectory(const Scene& scene, const ExternalTrajectory& path,
                            MemoizedReference& reference) {
  Assessment judgement = judge_values(scene, path, reference);
  if (std::ssize(path.columns) == std::ssize(scene.outputs.names)) return judgement;
  auto& detail = judgement.ending.detail;
  detail += fmt::format("{}in {}", detail.empty() ? "" : " ", fmt::join(names_of(scene, path), ", "));
  return judgement;
}

}  // namespace fde::bench
