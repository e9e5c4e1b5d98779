#pragma once

#include <ostream>

#include "search/question.hpp"

namespace fde {

// A scene with a kind of error and an accuracy, as a test parameter.
struct Asked {
  const char* scene;
  ErrorKind kind;
  double accuracy;
};
inline std::ostream& operator<<(std::ostream& out, const Asked& asked) {
  return out << asked.scene << " " << error_measure(asked.kind) << " " << asked.accuracy;
}

// The question over all columns.
inline Question question_of(const Scene& scene, const Asked& asked) {
  return {asked.kind, asked.accuracy, all_columns(scene)};
}

}  // namespace fde
