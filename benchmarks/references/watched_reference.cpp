#include "references/watched_reference.hpp"

#include <stdexcept>

#include "references/reference_of.hpp"

namespace fde {

Rows WatchedReference::at(const Grid& grid, const std::vector<int>& steps) {
  Rows columns(static_cast<Eigen::Index>(scene_.outputs.names.size()),
               static_cast<Eigen::Index>(steps.size()));
  for (std::size_t c = 0; c < steps.size(); ++c) {
    const double t = grid.time(steps[c]);
    auto found = known_.find(t);
    if (found == known_.end()) found = known_.emplace(t, reference(t).value).first;
    columns.col(static_cast<Eigen::Index>(c)) = found->second;
  }
  return columns;
}

Vec WatchedReference::bound(const Grid& grid) { return reference(grid.end).bound; }

ReferenceValue WatchedReference::reference(double t) {
  if (failure_) std::rethrow_exception(failure_);
  try {
    if (!exact_.at) exact_ = reference_of(scene_);
    return exact_.at(t);
  } catch (const std::runtime_error&) {
    failure_ = std::current_exception();
    throw;
  }
}

}  // namespace fde
