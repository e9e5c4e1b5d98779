#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/comparison.hpp"
#include "analysis/line_names.hpp"
#include "analysis/runs.hpp"
#include "command/command.hpp"
#include "command/command_line.hpp"
#include "records/merge.hpp"

namespace fde {
namespace {

// "machine, compiler, commit" of each build, once.
std::set<std::string> builds_of(const std::vector<Session>& sessions) {
  std::set<std::string> builds;
  for (const Session& s : sessions)
    builds.insert(fmt::format("{}, {}, commit {}", s.machine, s.compiler, s.commit));
  return builds;
}

std::set<std::string> machines_of(const std::vector<Session>& sessions) {
  std::set<std::string> machines;
  for (const Session& session : sessions) machines.insert(session.machine);
  return machines;
}

void compare_files(const std::string& first, const std::string& second, const Streams& streams,
                   const Scenes& known) {
  const auto [sessions_before, before] = read_runs(first, known);
  const auto [sessions_now, now] = read_runs(second, known);
  const Comparison comparison = compare(before, now);
  if (comparison.common == 0)
    throw std::invalid_argument(fmt::format("{} and {}: have no run in common", first, second));
  streams.out << fmt::format("first:  {}: {}\nsecond: {}: {}\n", first,
                             fmt::join(builds_of(sessions_before), "; "), second,
                             fmt::join(builds_of(sessions_now), "; "));
  if (machines_of(sessions_before) != machines_of(sessions_now))
    streams.out << "times are of different machines: they say nothing of the programs\n";
  streams.out << comparison_text(comparison, LineNames(now));
  if (comparison.is_worse()) throw WorseResults(second + ": an error grew or a verdict fell");
}

void merge_files(const std::vector<std::string>& files, const std::string& out, const Streams& streams,
                 const Scenes& known) {
  const auto merged = merge_results({files.begin(), files.end()}, out, known);
  streams.out << fmt::format("{}\n{} sessions, {} rows, {} repeated rows left out\n",
                             std::filesystem::absolute(out).string(), merged.sessions, merged.rows,
                             merged.repeated_rows);
}

}  // namespace

void add_results_commands(CommandLine& program, const Streams& streams, const Scenes& known) {
  auto first = std::make_shared<std::string>(), second = std::make_shared<std::string>();
  Subcommand compare_command(program, "compare", "What is worse or better in the second results file");
  compare_command.required("first", *first, "results file, before");
  compare_command.required("second", *second, "results file, now");
  compare_command.callback([=, &known] { compare_files(*first, *second, streams, known); });

  auto files = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  Subcommand merge_command(program, "merge", "Put results files together; sessions stay apart");
  merge_command.list("files", *files, "results files");
  merge_command.required("--out", *out, "the new results file");
  merge_command.callback([=, &known] {
    if (files->empty()) throw std::invalid_argument("files is required");
    merge_files(*files, *out, streams, known);
  });
}

}  // namespace fde
