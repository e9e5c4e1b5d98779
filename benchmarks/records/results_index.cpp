// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/results_index.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_reader.hpp"

namespace fde::bench {
namespace {

// Adds one line after the other to an index.
class Indexer {
 public:
  explicit Indexer(ResultsIndex& index) : index_(index) {}

  void add(const Session& session, std::uint64_t /*offset*/) {
    const auto same = [&](const Session& other) { return same_build(other, session); };
    builds_.push_back(std::ranges::find_if(index_.sessions, same) - index_.sessions.begin());
    index_.sessions.push_back(session);
  }

  void add(const SceneDescription& scene, std::uint64_t offset) {
    index_.scenes[scene.scene].push_back(offset);
  }

  void add(const Record& run, std::uint64_t offset) {
    index_.scenes.try_emplace(run.key.scene);
    IndexedRun placed;
    placed.examination = offset;
    placed.session = static_cast<std::uint32_t>(run.session);
    auto& last = last_.try_emplace(digest_of(run.key), -1).first->second;
    placed.before = std::exchange(last, std::ssize(index_.runs));
    if (placed.before >= 0) at(placed.before).is_latest = false;
    index_.runs.push_back(placed);
  }

  // The last examination by the same build takes the times.
  void add(const LaterTimes& times, std::uint64_t offset) {
    const auto last = last_.find(digest_of(times.key));
    auto place = last == last_.end() ? -1 : last->second;
    while (place >= 0 && builds_[at(place).session] != builds_.back()) place = at(place).before;
    if (place >= 0) at(place).take_times(offset, times.timing.session);
  }

 private:
  IndexedRun& at(std::int64_t place) { return index_.runs[static_cast<std::size_t>(place)]; }

  ResultsIndex& index_;
  std::vector<std::ptrdiff_t> builds_{};  // for each session the first of the same build
  std::unordered_map<Digest, std::int64_t, DigestHash> last_{};  // index of the latest examination of a run
};

}  // namespace

ResultsIndex index_results(const std::filesystem::path& file) {
  ResultsIndex index;
  Indexer indexer(index);
  ResultsReader reader(file);
  while (const auto line = reader.next())
    std::visit([&](const auto& of) { indexer.add(of, reader.begin()); }, *line);
  index.warning = reader.warning();
  return index;
}

SceneDescription read_scene(const LinesByOffset& file, std::uint64_t offset) {
  return std::get<SceneDescription>(parse_line(file.line(offset)));
}

}  // namespace fde::bench
