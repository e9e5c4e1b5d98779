// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/cache.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/reference/nonlinear/collocation.hpp"
#include "fdebench/reference/two_sided/solution.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/stepping/setup_time.hpp"

namespace fde::bench {

namespace {

using nlohmann::json;

// Increment with every change of the methods or of the file format that changes a reference.
constexpr int version = 6;

constexpr std::size_t digest_size = 64;

constexpr std::size_t most_bytes = std::size_t{256} << 20;  // of a file

std::vector<double> numbers(const Matrix& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

Matrix matrix_of(const std::vector<double>& numbers, Eigen::Index columns) {
  return Eigen::Map<const Matrix>(numbers.data(), std::ssize(numbers) / columns, columns);
}

json to_json(const reference::PanelTable& table) {
  json panels = json::array();
  for (const auto& panel : table.panels) {
    panels.push_back({{"from", panel.from},
                      {"to", panel.to},
                      {"values", numbers(panel.values)},
                      {"bound", numbers(panel.bound)}});
  }
  return panels;
}

// Throws json::exception if the file has other contents.
reference::PanelTable table_of(const json& panels, Eigen::Index size) {
  reference::PanelTable table;
  for (const auto& panel : panels) {
    const auto values = panel.at("values").get<std::vector<double>>();
    const auto bound = panel.at("bound").get<std::vector<double>>();
    table.panels.push_back({panel.at("from").get<double>(), panel.at("to").get<double>(),
                            matrix_of(values, size), matrix_of(bound, size).transpose()});
  }
  return table;
}

// Whether the time is one, and the panels cover [0, end] without gaps and all have the size of the problem
// and the same resolution.
bool fits(const TimedTable& table, const Problem& problem) {
  if (!(table.seconds >= 0.0) || !std::isfinite(table.seconds)) return false;
  double time = 0.0;
  for (const auto& panel : table.panels.panels) {
    const auto& first = table.panels.panels.front().values;
    if (panel.from != time || !(panel.to > time) || panel.bound.size() != problem.size() ||
        panel.values.rows() != first.rows() || first.rows() < 3 || !panel.values.allFinite() ||
        !(panel.bound.array() >= 0.0).all()) {
      return false;
    }
    time = panel.to;
  }
  return time == problem.end;
}

// Empty if it cannot be read, is not a regular file (a pipe might never end), or is larger than most_bytes.
std::string read(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) return {};
  const auto size = std::filesystem::file_size(file, problem);
  if (problem || size > most_bytes) return {};
  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

// The bytes after the SHA-256, if it is theirs.
std::optional<std::string_view> content_if_intact(std::string_view bytes) {
  if (bytes.size() < digest_size) return std::nullopt;
  const auto content = bytes.substr(digest_size);
  if (sha256(content) != bytes.substr(0, digest_size)) return std::nullopt;
  return content;
}

std::optional<std::filesystem::path> variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  if (value == nullptr) return std::nullopt;
  return value;
}

// Whether the folder is in a $HOME that does not exist, as for some services: it must not be created.
bool in_missing_home(const std::filesystem::path& folder) {
  const auto home = variable("HOME");
  std::error_code none;
  if (!home || !home->is_absolute() || std::filesystem::exists(*home, none)) return false;
  const auto below = folder.lexically_normal().lexically_relative(home->lexically_normal());
  return !below.empty() && *below.begin() != "..";
}

TimedTable table_of(const Problem& problem) {
  const double start = thread_seconds();
  auto panels =
      has_right_rows(problem) ? reference::two_sided_table(problem) : reference::reference_table(problem);
  return {std::move(panels), thread_seconds() - start};
}

reference::Reference from_table(TimedTable table, const Problem& problem) {
  reference::Reference reference = has_right_rows(problem)
                                       ? two_sided_reference(std::move(table.panels), problem)
                                       : reference_from_table(std::move(table.panels), problem);
  reference.evidence = reference::Evidence::two_methods;
  reference.seconds = table.seconds;
  return reference;
}

}  // namespace

reference::Reference computed_reference(const Problem& problem) {
  return from_table(table_of(problem), problem);
}

std::filesystem::path ReferenceCache::file_of(const std::string& key) const {
  return folder_.value() / (sha256(key) + ".reference");
}

std::optional<TimedTable> ReferenceCache::load(const std::string& key, const Problem& problem) const {
  if (!folder_) return std::nullopt;
  const std::string bytes = read(file_of(key));
  const auto content = content_if_intact(bytes);
  if (!content) return std::nullopt;
  try {
    const json file = json::from_cbor(*content);
    if (file.at("key") != key) return std::nullopt;
    TimedTable table{table_of(file.at("panels"), problem.size()), file.at("seconds").get<double>()};
    return fits(table, problem) ? std::optional(std::move(table)) : std::nullopt;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

void ReferenceCache::store(const std::string& key, const TimedTable& table) const {
  if (!folder_ || in_missing_home(*folder_)) return;
  const auto content =
      json::to_cbor(json{{"key", key}, {"seconds", table.seconds}, {"panels", to_json(table.panels)}});
  const std::string text(content.begin(), content.end());
  if (text.size() > most_bytes - digest_size) return;
  std::error_code ignored;
  std::filesystem::create_directories(*folder_, ignored);
  try {
    AtomicFile file(file_of(key));
    file.write(sha256(text) + text);
    file.commit();
  } catch (const std::invalid_argument&) {
    return;
  }
}

std::optional<std::filesystem::path> cache_folder() {
  if (const auto ours = variable("FDEBENCH_CACHE")) return ours->empty() ? std::nullopt : ours;
  if (const auto caches = variable("XDG_CACHE_HOME"); caches && caches->is_absolute())
    return *caches / "fdebench";
  if (const auto home = variable("HOME"); home && home->is_absolute()) return *home / ".cache" / "fdebench";
  return std::nullopt;
}

std::string reference_key(const std::string& name, const Problem& problem) {
  std::string key = fmt::format("fdebench reference {}\n{}\nend {}\n", version, name, problem.end);
  for (const auto& [order, initial, side] : problem.components)
    key += fmt::format("order {} initial {}\n", order, fmt::join(initial, " "));
  if (!problem.jump_times.empty()) key += fmt::format("jumps {}\n", fmt::join(problem.jump_times, " "));
  const auto& lags = problem.delays.lags;
  if (!lags.empty()) key += fmt::format("lags {}\n", fmt::join(lags, " "));
  BoundProblem bound(problem);
  bound.set_solution([](double t, Out y) {
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] = std::sin(2.0 * t + static_cast<double>(i));
  });
  constexpr int points = 7;
  Vec f(problem.size());
  for (int k = 0; k < points; ++k) {
    const double t = problem.end * k / points;
    Vec y = taylor_part(problem, 0.0);
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] += 0.25 * std::sin(3.0 * k + static_cast<double>(i));
    bound.problem().rhs(t, y, f);
    key += fmt::format("f {}\n", fmt::join(f, " "));
    for (const Reset& reset : problem.resets) {
      f = y;
      reset.state(t, y, f);
      key += fmt::format("event {} {} sets {}\n", static_cast<int>(reset.crossing), reset.value(t, y),
                         fmt::join(f, " "));
    }
    if (lags.empty()) continue;
    problem.delays.before(-lags.back() * (k + 1) / points, y);
    key += fmt::format("before {}\n", fmt::join(y, " "));
  }
  return key;
}

reference::Reference cached_reference(const std::string& name, const Problem& problem,
                                      const ReferenceCache& cache) {
  const std::string key = reference_key(name, problem);
  if (auto known = cache.load(key, problem)) return from_table(std::move(*known), problem);
  auto table = table_of(problem);
  cache.store(key, table);
  return from_table(std::move(table), problem);
}

}  // namespace fde::bench
