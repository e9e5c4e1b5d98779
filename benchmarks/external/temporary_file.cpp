// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/external/temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace fde::bench {

TemporaryFile::TemporaryFile(std::string_view suffix) {
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  if (error) throw std::system_error(error, "the folder of temporary files, $TMPDIR or /tmp");
  std::string name = (folder / "fdebench-XXXXXX").string();
  name += suffix;
  const RegistrationGuard guard;
  descriptor_ = mkostemps(name.data(), static_cast<int>(suffix.size()), O_CLOEXEC);
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), name + ": cannot be written");
  path_ = name;
  trace_.emplace(name);
}

TemporaryFile::~TemporaryFile() {
  close(descriptor_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void TemporaryFile::write(std::string_view text) const {
  while (!text.empty()) {
    const auto count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw std::system_error(errno, std::generic_category(), path_.string() + ": cannot be written");
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace fde::bench
