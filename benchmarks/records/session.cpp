// SPDX-License-Identifier: MIT
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "build_facts.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/records/well_formed.hpp"

namespace fde::bench {
namespace {

// The name of the processor from /proc/cpuinfo, or the architecture.
std::string machine_name(const utsname& system) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return system.machine;
}

std::string node_name() {
  const char* name = std::getenv("FDEBENCH_NODE");  // NOLINT(concurrency-mt-unsafe): nothing sets it
  if (name == nullptr || *name == '\0') return {};
  require_name("FDEBENCH_NODE", name);
  return name;
}

}  // namespace

Session this_session() {
  utsname system{};
  uname(&system);
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return {.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now)),
          .machine = machine_name(system),
          .system = fmt::format("{} {} {}", system.sysname, system.release, system.machine),
          .compiler = build_facts::compiler,
          .flags = build_facts::flags,
          .commit = build_facts::commit,
          .version = build_facts::version,
          .cores = std::thread::hardware_concurrency(),
          .node = node_name()};
}

}  // namespace fde::bench
