// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/study_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/files/unfinished.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view plan_name = "plan.json", shard_prefix = "shard-";

// Bytes of a run of usual length, in two lines.
double bytes_of(const RunKey& run) {
  constexpr double values = 900.0;
  return values + 2.0 * static_cast<double>(line_of(LaterTimes{.key = run}).size());
}

Json json_of(const PlannedWork& work) {
  return {{"scenes", work.scenes},
          {"runs", work.runs},
          {"seconds_examine", work.seconds.examination},
          {"seconds_time", work.seconds.timing},
          {"bytes", static_cast<std::int64_t>(std::llround(work.bytes))}};
}

// For each scene the number of its part.
std::map<SceneSettings, std::size_t> distributed(const PlannedScenes& scenes, std::size_t count) {
  std::vector<const PlannedScenes::value_type*> longest;
  for (const auto& scene : scenes) longest.push_back(&scene);
  std::ranges::stable_sort(longest, std::ranges::greater{},
                           [](const auto* scene) { return scene->second.seconds.total(); });
  std::vector<double> seconds(count);
  std::map<SceneSettings, std::size_t> parts;
  for (const auto* scene : longest) {
    const auto least = std::ranges::min_element(seconds);
    *least += scene->second.seconds.total();
    parts.emplace(scene->first, static_cast<std::size_t>(least - seconds.begin()));
  }
  return parts;
}

// Removes the parts of an earlier plan, which has plan.json.
void remove_parts(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / plan_name)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (name.starts_with(shard_prefix) && name.ends_with(equation_file_extension))
      std::filesystem::remove(entry.path());
  }
}

// A folder for files that are renamed when all are written. It goes at the end.
struct UnfinishedFolder {
  explicit UnfinishedFolder(const std::filesystem::path& beside) : path(unfinished_name(beside)) {
    std::filesystem::create_directory(path);
  }
  UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;
  ~UnfinishedFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  std::filesystem::path path;
};

// The name and the text of each file of a plan, plan.json last.
std::vector<std::pair<std::string, std::string>> files_of(const Study& study,
                                                          const std::vector<StudyShard>& shards,
                                                          const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  Json plan{{"study", study.file}, {"checksum", study.checksum}, {"shards", Json::array()}};
  for (const auto& of : shards) {
    const auto name = fmt::format("{}{:04}{}", shard_prefix, files.size() + 1, equation_file_extension);
    files.emplace_back(name, text_of(of.study, folder));
    Json shard{{"file", name}};
    shard.update(json_of(of.work));
    plan["shards"].push_back(std::move(shard));
  }
  files.emplace_back(plan_name, plan.dump(2) + '\n');
  return files;
}

}  // namespace

PlannedWork& PlannedWork::operator+=(const PlannedWork& other) {
  scenes += other.scenes;
  runs += other.runs;
  seconds.examination += other.seconds.examination;
  seconds.timing += other.seconds.timing;
  bytes += other.bytes;
  return *this;
}

PlannedScenes planned_scenes(const Forecast& expected) {
  constexpr double description = 1000.0;  // bytes
  PlannedScenes scenes;
  for (const auto& [run, seconds] : expected) {
    auto& work = scenes.try_emplace(run.scene, PlannedWork{.scenes = 1, .bytes = description}).first->second;
    work += {.runs = 1, .seconds = seconds, .bytes = bytes_of(run)};
  }
  return scenes;
}

PlannedWork sum_of(const PlannedScenes& scenes) {
  PlannedWork sum;
  for (const auto& scene : scenes) sum += scene.second;
  return sum;
}

std::vector<StudyShard> shards_of(const Study& study, const PlannedScenes& scenes, int count) {
  const auto parts = distributed(scenes, static_cast<std::size_t>(count));
  std::vector<StudyShard> shards(static_cast<std::size_t>(count), {.study = {.title = study.title}});
  for (const auto& scene : scenes) shards[parts.at(scene.first)].work += scene.second;
  for (const auto& family : study.families) {
    std::vector<StudyFamily> split(shards.size(), {.position = family.position, .settings = family.settings});
    for (const auto& scene : family.scenes) {
      const auto part = parts.find(scene.key());
      if (part != parts.end()) split[part->second].scenes.push_back(scene);
    }
    for (std::size_t i = 0; i < split.size(); ++i)
      if (!split[i].scenes.empty()) shards[i].study.families.push_back(std::move(split[i]));
  }
  std::erase_if(shards, [](const auto& shard) { return shard.study.families.empty(); });
  return shards;
}

void write_plan(const Study& study, const std::vector<StudyShard>& shards,
                const std::filesystem::path& folder) {
  const auto files = files_of(study, shards, folder);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) cannot_write(folder, failure);
  try {
    const UnfinishedFolder unfinished(folder / plan_name);
    for (const auto& [name, text] : files) {
      AtomicFile file(unfinished.path / name);
      file.write(text);
      file.commit();
    }
    remove_parts(folder);
    for (const auto& file : files) std::filesystem::rename(unfinished.path / file.first, folder / file.first);
  } catch (const std::filesystem::filesystem_error& wrong) {
    cannot_write(folder, wrong.code());
  }
}

}  // namespace fde::bench
