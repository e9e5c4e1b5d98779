// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/data_file.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "fdebench/benchmarks/external/process_cleanup.hpp"

namespace fde::bench {
namespace {

constexpr std::uintmax_t most_bytes_of_pipe = std::uintmax_t{1} << 30;

// Copies a pipe to a temporary file; nullptr if the name is not a pipe.
std::unique_ptr<const TemporaryFile> file_of_pipe(const std::string& name) {
  const std::filesystem::path path = name == "-" ? "/dev/stdin" : name;
  std::error_code ignored;
  if (!std::filesystem::is_fifo(path, ignored)) return nullptr;
  std::ifstream stream(path, std::ios::binary);
  auto file = std::make_unique<const TemporaryFile>(".csv");
  std::string buffer(std::size_t{1} << 16, '\0');
  for (std::uintmax_t bytes = 0; stream;) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    bytes += count;
    if (bytes > most_bytes_of_pipe)
      throw std::invalid_argument(fmt::format("{}: is longer than {} bytes", name, most_bytes_of_pipe));
    file->write(std::string_view(buffer).substr(0, count));
  }
  return file;
}

}  // namespace

ExternalTrajectory read_data(const std::string& file, const Scene& scene, TrajectorySource source) {
  const std::string name = file == "-" ? "standard input" : file;
  const auto piped = file_of_pipe(file);
  if (piped) return read_trajectory(piped->path(), scene, name, source);
  return read_trajectory(file == "-" ? "/dev/stdin" : file, scene, name, source);
}

std::string text_of(const ChiSquared& chi_squared) {
  const auto probability = chi_squared.probability();
  return fmt::format("chi_squared {:.6g}\ndegrees_of_freedom {}\n", chi_squared.value, chi_squared.degrees) +
         (probability ? fmt::format("probability {:.3g}\n", *probability) : "");
}

}  // namespace fde::bench
