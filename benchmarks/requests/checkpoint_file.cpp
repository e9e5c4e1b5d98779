// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/checkpoint_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "fdebench/schemes/history/block_kernels.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view begin_of_header = R"({"fdebench checkpoint":)";
constexpr std::size_t digest_size = 64;
constexpr std::size_t piece = std::size_t{1} << 20;

[[noreturn]] void reject_file(const fs::path& path, const std::string& reason) {
  throw std::invalid_argument(fmt::format("{}: {}", path.string(), reason));
}

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

// Buffered output to a file; appends the SHA-256 of the bytes at the end.
class ChecksummedOutput {
 public:
  explicit ChecksummedOutput(const fs::path& path) : file_(path) {}

  void add(std::string_view bytes) {
    if (bytes.size() >= piece) {
      flush();
      write_out(bytes);
      return;
    }
    gathered_ += bytes;
    if (gathered_.size() >= piece) flush();
  }

  void finish() {
    flush();
    file_.write(sum_.digest());
    file_.commit();
  }

  // Number of bytes in the file after the buffer is flushed.
  [[nodiscard]] std::uintmax_t count() const { return count_; }

 private:
  void flush() {
    write_out(gathered_);
    gathered_.clear();
  }
  void write_out(std::string_view bytes) {
    sum_.add(bytes);
    file_.write(bytes);
    count_ += bytes.size();
  }

  AtomicFile file_;
  std::uintmax_t count_ = digest_size;
  Sha256 sum_;
  std::string gathered_;
};

// Whether the last bytes of a file are the checksum of the bytes before them.
bool has_valid_checksum(std::ifstream& stream, std::uintmax_t size) {
  if (size < digest_size) return false;
  Sha256 sum;
  std::string bytes(piece, '\0');
  for (auto left = size - digest_size; left > 0;) {
    const auto count = std::min<std::uintmax_t>(left, piece);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(count))) return false;
    sum.add(std::string_view(bytes).substr(0, count));
    left -= count;
  }
  std::string digest(digest_size, '\0');
  stream.read(digest.data(), digest_size);
  return stream && digest == sum.digest();
}

}  // namespace

CheckpointFile::CheckpointFile(fs::path path, std::chrono::duration<double> between, RunFacts facts,
                               fde::StateArchiver observers, std::function<void(const std::string&)> say)
    : path_(std::move(path)),
      between_(between),
      facts_(std::move(facts)),
      observers_(std::move(observers)),
      say_(std::move(say)) {
  if (is_there(path_)) check();
  const AtomicFile trial(path_);
}

void CheckpointFile::check() const {
  if (!fs::is_regular_file(path_)) reject_file(path_, "is no file");
  std::ifstream stream(path_, std::ios::binary);
  std::string begin(begin_of_header.size(), '\0');
  if (!stream.read(begin.data(), static_cast<std::streamsize>(begin.size())) || begin != begin_of_header)
    reject_file(path_, "is no checkpoint, and is not replaced by one");
  stream.seekg(0);
  if (!has_valid_checksum(stream, fs::file_size(path_)))
    reject_file(path_, "is damaged: its checksum is of something else");
  stream.seekg(0);
  std::string header;
  std::getline(stream, header);
  compare(header);
}

void CheckpointFile::compare(const std::string& header) const {
  const Json known = Json::parse(header, nullptr, false);
  const Json run = known.is_object() ? known.value("run", Json::object()) : Json::object();
  for (const auto& [name, value] : facts_) {
    const auto theirs = run.value(name, Json());
    if (theirs == value) continue;
    reject_file(path_, fmt::format("is of another run: {} = {}, not {}", name,
                                   theirs.is_string() ? theirs.get<std::string>() : "unknown", value));
  }
}

bool CheckpointFile::resume(const fde::StateArchiver& state) {
  if (!is_there(path_)) return false;
  std::ifstream stream(path_, std::ios::binary);
  std::string header;
  std::getline(stream, header);
  const auto used = header.size() + 1 + digest_size;
  ReadingArchive archive(
      [&](char* bytes, std::size_t count) {
        if (!stream.read(bytes, static_cast<std::streamsize>(count)))
          throw std::invalid_argument("cannot be read");
      },
      fs::file_size(path_) - used);
  try {
    observers_(archive);
    state(archive);
    archive.end();
  } catch (const std::invalid_argument& problem) {
    reject_file(path_, problem.what());
  }
  spent_.continued = true;
  return true;
}

void CheckpointFile::offer(const fde::StateArchiver& state) {
  if (Clock::now() - written_ < between_) return;
  try {
    write(state);
    failed_ = false;
  } catch (const std::invalid_argument& problem) {
    if (!failed_ && say_) say_(problem.what());
    failed_ = true;
  }
  written_ = Clock::now();
}

void CheckpointFile::write(const fde::StateArchiver& state) {
  const auto start = Clock::now();
  ChecksummedOutput bytes(path_);
  Json run;
  for (const auto& [name, value] : facts_) run[name] = value;
  bytes.add(Json{{"fdebench checkpoint", 1}, {"run", run}}.dump() + "\n");
  WritingArchive archive([&](std::string_view more) { bytes.add(more); });
  observers_(archive);
  state(archive);
  bytes.finish();
  const std::chrono::duration<double> taken = Clock::now() - start;
  ++spent_.count;
  spent_.bytes = bytes.count();
  spent_.seconds += taken.count();
}

void CheckpointFile::remove() const {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

namespace {

// The output times as a request has them.
struct TimesText {
  std::string operator()(const AllTimes& /*all*/) const { return "all"; }
  std::string operator()(const GivenTimes& at) const {
    return fmt::format("at {}", fmt::join(at.times, ","));
  }
  std::string operator()(const EveryTime& every) const { return fmt::format("every {}", every.stride); }
  std::string operator()(const SpreadTimes& points) const { return fmt::format("points {}", points.count); }
};

RunFacts facts_of(const Scene& scene, const SolveRequest& request, const RequestedRun& run) {
  const Session session = this_session();
  return {{"program",
           fmt::format("{} {} {} {}", session.version, session.commit, session.compiler, session.flags)},
          {"instructions", std::string(vector_targets().front())},
          {"scene", scene.name},
          {"end", fmt::format("{}", scene.problem.end)},
          {"scheme", std::string(run.scheme.id)},
          {"steps", resolution_text(run.settings)},
          {"grid", grid_text(run.settings.grading)},
          {"history", std::string(name(run.settings.history))},
          {"tolerance", fmt::format("{}", run.settings.newton_tolerance)},
          {"times", std::visit(TimesText(), request.times)}};
}

}  // namespace

std::optional<CheckpointFile> requested_checkpoint(const Scene& scene, const SolveRequest& request,
                                                   const RequestedRun& run, RetainedColumns& kept,
                                                   const std::function<void(const std::string&)>& say) {
  if (!request.checkpoint) return std::nullopt;
  const auto& [file, between] = *request.checkpoint;
  if (const auto reason = unsupported_checkpoints_reason(run.scheme, scene.problem))
    refuse_value("checkpoint", file.string(), {fmt::format("left out: {} {}", run.scheme.id, *reason)});
  return std::optional<CheckpointFile>(
      std::in_place, file, between, facts_of(scene, request, run),
      [&kept](Archive& archive) { archive(kept); }, say);
}

}  // namespace fde::bench
