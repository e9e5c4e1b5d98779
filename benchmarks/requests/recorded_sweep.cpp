// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/recorded_sweep.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {
namespace {

// The runs that a sweep has asked for, each with its last times.
class SweptRuns {
 public:
  // The callbacks that keep what passes through these.
  [[nodiscard]] SweepCallbacks keeping(const SweepCallbacks& to) {
    SweepCallbacks hooks = to;
    hooks.recorded = [this, to](const RunKey& key) {
      auto run = to.recorded(key);
      if (run) keep(*run);
      return run;
    };
    hooks.append = [this, to](const Record& run) {
      keep(run);
      to.append(run);
    };
    hooks.append_times = [this, to](const Record& run) {
      keep(run);
      to.append_times(run);
    };
    return hooks;
  }

  // Those of a scene in the order in which they came; the scenes, which threads share, in this order.
  [[nodiscard]] std::vector<Record> sorted(const std::vector<SceneVariant>& scenes) && {
    std::map<SceneSettings, std::size_t> order;
    for (const SceneVariant& scene : scenes) order.emplace(scene.key(), order.size());
    std::ranges::stable_sort(runs_, {}, [&](const Record& run) { return order.at(run.key.scene); });
    return std::move(runs_);
  }

 private:
  void keep(const Record& run) {
    const std::scoped_lock lock(mutex_);
    const auto [place, is_new] = places_.try_emplace(run.key, runs_.size());
    if (is_new) {
      runs_.push_back(run);
    } else {
      runs_[place->second] = run;
    }
  }

  std::mutex mutex_;  // several threads ask for recorded runs
  std::map<RunKey, std::size_t> places_;
  std::vector<Record> runs_;
};

SweepCallbacks without_file(const SweepListener& listener) {
  return {
      .recorded = [](const RunKey&) { return std::optional<Record>(); },
      .append = [&](const Record& run) { listener.on_run ? listener.on_run(run) : void(); },
      .append_times = [](const Record&) {},
      .on_event = [&](const SweepEvent& event) { listener.on_event ? listener.on_event(event) : void(); }};
}

// Appends lines to a file; one that could not be read back is left out, and the sweep goes on.
class Appender {
 public:
  Appender(ResultsFile& file, const SweepListener& listener) : file_(file), listener_(listener) {}

  [[nodiscard]] SweepCallbacks callbacks() {
    SweepCallbacks hooks = without_file(listener_);
    hooks.recorded = [this](const RunKey& key) { return file_.recorded(key); };
    hooks.append = [this, told = hooks.append](const Record& run) {
      told(run);
      write([&] { file_.append(run); });
    };
    hooks.append_times = [this](const Record& run) { write([&] { file_.append_times(run); }); };
    hooks.describes = [this](const SceneSettings& scene) { return file_.describes(scene); };
    hooks.append_scene = [this](const SceneDescription& scene) { write([&] { file_.append(scene); }); };
    return hooks;
  }

  void require_written() const {
    if (!unwritten_.empty()) throw NumericalFailure(unwritten_);
  }

 private:
  template <typename Append>
  void write(const Append& append) {
    try {
      append();
    } catch (const UnreadableLine& reason) {
      if (unwritten_.empty()) unwritten_ = reason.what();
    }
  }

  ResultsFile& file_;
  const SweepListener& listener_;
  std::string unwritten_{};  // why the first line is left out
};

std::vector<Record> runs_of(const std::vector<Sweep>& sweeps, const SweepCallbacks& to) {
  std::vector<Record> all;
  for (const Sweep& one : sweeps) {
    SweptRuns swept;
    run_sweep(one, swept.keeping(to));
    std::ranges::move(std::move(swept).sorted(one.scenes), std::back_inserter(all));
  }
  return all;
}

}  // namespace

void run_into(ResultsFile& file, std::span<const Sweep> sweeps, const SweepListener& listener) {
  Appender appender(file, listener);
  for (const Sweep& one : sweeps) run_sweep(one, appender.callbacks());
  appender.require_written();
}

std::vector<Record> sweep(const SweepRequest& request, const std::filesystem::path& results,
                          const SweepListener& listener) {
  const auto sweeps = sweeps_of(request);
  ResultsFile file(results);
  if (listener.warn && !file.warning().empty()) listener.warn(file.warning());
  Appender appender(file, listener);
  auto runs = runs_of(sweeps, appender.callbacks());
  appender.require_written();
  return runs;
}

std::vector<Record> sweep(const SweepRequest& request, const SweepListener& listener) {
  return runs_of(sweeps_of(request), without_file(listener));
}

}  // namespace fde::bench
