#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measures/judge.hpp"
#include "references/watched_reference.hpp"
#include "scenes/scene.hpp"

namespace fde {

// A trajectory that another program wrote.
struct WrittenPath {
  std::vector<Eigen::Index> columns{};  // those of the scene that it has, by their place among its names
  std::vector<double> times{};          // increasing, the last above 0
  Rows values{};                        // one row a column, one column a time
  std::optional<double> seconds{};      // that the solve took, where the program says so
};

// Reads CSV with the header t,COLUMN,... and one row a time, in [0, end] of the scene. The columns are some
// of the scene's, in any order; what else `solve` prints may stand there, and is passed over. A value may be
// any number, infinite or none; a time may not. Quoted names, a # before the header, spaces round cells, \r\n
// and empty lines at the end are taken, and a line `# seconds: S` before the header. Throws
// std::invalid_argument naming file and line of all else, and of a file with more than 10 million values. The
// file is called `name`, by default by its path.
WrittenPath read_path(const std::filesystem::path& file, const Scene& scene, const std::string& name = "");

// Judges its columns as those of a run are: at all of its times up to 8192, otherwise at as many and the
// first 16. It ends where a value is not finite. Where columns of the scene are missing the ending's detail
// names those that are there.
Judgement judge_path(const Scene& scene, const WrittenPath& path);

// The same at all of its times, by the reference of all columns of the scene.
Judgement judge_path(const Scene& scene, const WrittenPath& path, WatchedReference& reference);

}  // namespace fde
