#include "analysis/line_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace fde {
namespace {

std::array<std::string, 4> means_of(const Setup& setup) {
  return {std::string(name(setup.history)), setup.grading == 1.0 ? "" : grid_text(setup.grading),
          fmt::format("tolerance {:g}", setup.tolerance),
          std::isfinite(setup.budget) ? fmt::format("budget {:g} s", setup.budget) : "no budget"};
}

// Those means that are told, behind each other.
std::string told(const Setup& setup, const std::array<bool, 4>& which) {
  const auto means = means_of(setup);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (which[i] && !means[i].empty()) words.push_back(means[i]);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

LineNames::LineNames(const Runs& runs) {
  const MeasuredRun* first = nullptr;
  for (const auto* some : {&runs.finished, &runs.failed}) {
    for (const MeasuredRun& run : *some) {
      if (run.key.external) {
        external_.insert(run.key.scheme);
        continue;
      }
      if (first == nullptr) first = &run;
      const auto means = means_of(run.key.setup), others = means_of(first->key.setup);
      for (std::size_t i = 0; i < means.size(); ++i) differ_[i] = differ_[i] || means[i] != others[i];
    }
  }
}

std::string LineNames::name(const std::string& scheme, const Setup& setup) const {
  constexpr std::array grid_alone{false, true, false, false};
  const auto means = told(setup, external_.contains(scheme) ? grid_alone : differ_);
  return means.empty() ? scheme : fmt::format("{}, {}", scheme, means);
}

}  // namespace fde
