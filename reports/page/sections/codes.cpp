// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/counted_error.hpp"
#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr const char* own_code = "fdebench";

// The runs of one code on one scene: of fdebench, or of another program with all of its settings.
struct CodeRuns {
  std::string code{};
  ProgramFacts program{};
  std::vector<const Record*> finished{}, failed{};
};

std::string code_of(const Record& run) {
  if (!run.key.external) return own_code;
  return run.program.code.empty() ? run.key.scheme : run.program.code;
}

// The codes of a scene, fdebench first, then in the order of their runs.
class Codes {
 public:
  void add(RunSpan runs, std::vector<const Record*> CodeRuns::*kept) {
    for (const Record& run : runs) {
      auto& of = at(code_of(run));
      if (run.program != ProgramFacts{}) of.program = run.program;
      (of.*kept).push_back(&run);
    }
  }

  [[nodiscard]] bool has_others() const { return codes_.size() > 1; }
  [[nodiscard]] const std::vector<CodeRuns>& all() const { return codes_; }

 private:
  CodeRuns& at(const std::string& code) {
    const auto found = std::ranges::find(codes_, code, &CodeRuns::code);
    return found != codes_.end() ? *found : codes_.emplace_back(CodeRuns{.code = code});
  }

  std::vector<CodeRuns> codes_{{.code = own_code, .program = {.code = own_code, .language = "C++"}}};
};

// The quickest run within the error; nullptr if there is none.
const Record* quickest(const CodeRuns& code, const ErrorKind& kind, double accuracy) {
  const Record* best = nullptr;
  for (const auto* run : code.finished) {
    const auto error = counted_error(*run, kind);
    const auto time = time_of(*run);
    if (!error || !error->is_within(accuracy) || !time) continue;
    if (best == nullptr || time->median < time_of(*best)->median) best = run;
  }
  return best;
}

// The run with the smallest error; nullptr without finished runs.
const Record* most_accurate(const CodeRuns& code, const ErrorKind& kind) {
  const Record* best = nullptr;
  for (const auto* run : code.finished) {
    const auto error = (*run)[error_measure(kind)];
    if (error && (best == nullptr || *error < (*best)[error_measure(kind)])) best = run;
  }
  return best;
}

json cell_facts(const PageInput& page, const CodeRuns& code, const CodeRuns& own, const ErrorKind& kind,
                double accuracy) {
  if (const auto* run = quickest(code, kind, accuracy)) {
    auto facts = run_facts(page, *run, {});
    const double seconds = time_of(*run)->median;
    facts["error"] = fact((*run)[error_measure(kind)]);
    facts["seconds"] = fact(seconds);
    if (const auto setup = (*run)["time_setup"]; setup && !run->timing.first_run)
      facts["first_seconds"] = fact(seconds + *setup);
    facts["start_seconds"] = fact((*run)["time_start"]);
    const auto* ours = quickest(own, kind, accuracy);
    if (run->key.external && ours != nullptr) facts["ratio"] = fact(seconds / time_of(*ours)->median);
    return facts;
  }
  const auto* run = most_accurate(code, kind);
  if (run == nullptr) return json::object();
  auto best = run_facts(page, *run, {});
  best["error"] = fact((*run)[error_measure(kind)]);
  return {{"best", best}};
}

// How the first run of a code that finished none ended, in its own words if it has some.
json reason_facts(const CodeRuns& code) {
  if (!code.finished.empty() || code.failed.empty()) return json::object();
  return ending_facts(code.failed.front()->ending);
}

json row_of(const PageInput& page, const CodeRuns& code, const CodeRuns& own, const ErrorKind& kind) {
  json row{{"code", code.code},
           {"version", code.program.version},
           {"language", code.program.language},
           {"cells", json::array()}};
  row.update(reason_facts(code));
  for (const double accuracy : default_accuracies)
    row["cells"].push_back(cell_facts(page, code, own, kind, accuracy));
  return row;
}

}  // namespace

json codes_section(const PageInput& page) {
  std::vector<std::pair<SceneSettings, Codes>> scenes;
  bool is_octave = false;
  for (const RunSpan runs : by_scene(page.runs.finished)) {
    const SceneSettings& scene = runs.front().key.scene;
    Codes codes;
    codes.add(runs, &CodeRuns::finished);
    codes.add(of_scene(page.runs.failed, scene), &CodeRuns::failed);
    if (!codes.has_others()) continue;
    for (const auto& code : codes.all())
      is_octave = is_octave || code.program.language.find("Octave") != std::string::npos;
    scenes.emplace_back(scene, std::move(codes));
  }
  if (scenes.empty()) return {};
  json groups = json::object();
  for (const ErrorKind& kind : error_kinds) {
    auto& of_kind = groups[error_measure(kind)];
    for (const auto& [scene, codes] : scenes) {
      json rows = json::array();
      for (const auto& code : codes.all()) rows.push_back(row_of(page, code, codes.all().front(), kind));
      const auto columns = compared_text(page.runs, scene);
      of_kind.push_back({{"title", fmt::format("{}{}", name_of_scene(page, scene).title,
                                               columns.empty() ? "" : ": errors over " + columns)},
                         {"rows", rows}});
    }
  }
  return {{"id", "codes"}, {"accuracies", default_accuracies}, {"octave", is_octave}, {"groups", groups}};
}

}  // namespace fde::bench
