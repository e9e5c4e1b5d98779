// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/drawing_program.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "fdebench/benchmarks/external/process_cleanup.hpp"
#include "fdebench/benchmarks/external/shell_command.hpp"
#include "fdebench/benchmarks/files/atomic_file.hpp"

namespace fde::bench {
namespace {

constexpr double most_seconds = 120.0;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 20;

// The first line that is not blank.
std::string first_line_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line) && line.find_first_not_of(" \t\r") == std::string::npos) {
  }
  return line;
}

// Runs a program, by its command line, with one argument, and returns the first line that it printed.
std::string draw(const std::string& program, const std::string& command,
                 const std::filesystem::path& argument, const std::string& out) {
  const TemporaryFile said(".txt"), complained(".txt");
  const auto end = run_command(command, argument.string(), said.descriptor(), complained.descriptor(),
                               {most_seconds, most_bytes});
  if (end.status == CommandResult::Status::exited && end.code == 0) return first_line_of(said.path());
  constexpr int not_found = 127;  // of a shell
  if (end.code == not_found)
    throw std::invalid_argument(fmt::format("{}: {} draws figures, and is not installed", out, program));
  const auto complaint = first_line_of(complained.path());
  constexpr int refused = 2;  // by a script of reports/plot/, in words for the user
  if (end.code == refused && !complaint.empty()) throw std::invalid_argument(complaint);
  throw std::invalid_argument(fmt::format(
      "{}: cannot be drawn by {}: {}", out, program,
      complaint.empty() ? fmt::format("it ended with code {} and no word", end.code) : complaint));
}

}  // namespace

std::string draw_by_node(const std::filesystem::path& script, const std::filesystem::path& request,
                         const std::string& out) {
  return draw("node of Debian's nodejs", fmt::format("node '{}'", script.string()), request, out);
}

void print_on_paper(const std::filesystem::path& svg, const std::string& out) {
  const TemporaryFile pdf(".pdf");
  draw("rsvg-convert of Debian's librsvg2-bin",
       fmt::format("rsvg-convert --format=pdf --output='{}'", pdf.path().string()), svg, out);
  std::ifstream stream(pdf.path(), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  AtomicFile file(out);
  file.write(bytes);
  file.commit();
}

}  // namespace fde::bench
