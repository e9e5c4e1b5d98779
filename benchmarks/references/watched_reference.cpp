#include "references/watched_reference.hpp"

#include <stdexcept>

#include "references/reference_of.hpp"

namespace fde {

Rows WatchedReference::at(const std::vector<double>& times) {
  Rows columns(static_cast<Eigen::Index>(scene_.outputs.names.size()),
               static_cast<Eigen::Index>(times.size()));
  for (std::size_t c = 0; c < times.size(); ++c) {
    const double t = times[c];
    auto found = known_.find(t);
    if (found == known_.end()) found = known_.emplace(t, reference(t).value).first;
    columns.col(static_cast<Eigen::Index>(c)) = found->second;
  }
  return columns;
}

Vec WatchedReference::bound(double t) { return reference(t).bound; }

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
