#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "page/chart_number.hpp"
#include "page/page_data.hpp"
#include "references/reference_of.hpp"
#include "scenes/registry.hpp"
#include "scenes/variant.hpp"

namespace fde {
namespace {

using nlohmann::json;

constexpr int first_times = 120, most_times = 700;
constexpr double allowed = 0.004;         // of a column's range, between a curve and the lines that draw it
constexpr Eigen::Index most_columns = 6;  // of hundreds of a diffusion
constexpr int digits = 4;

// The solution at times that are close together where it bends.
class Samples {
 public:
  Samples(const Scene& scene, Eigen::Index columns)
      : reference_(reference_of(scene)), columns_(columns), end_(scene.problem.end) {
    for (int i = 0; i <= first_times; ++i) add(end_ * i / first_times);
    const auto rows = values_.size();
    Vec low = values_.begin()->second, high = low;
    for (const auto& [t, value] : values_) low = low.cwiseMin(value), high = high.cwiseMax(value);
    range_ = high - low;
    if (rows < 2) return;
    for (auto left = values_.begin(); std::next(left) != values_.end();) left = refined(left);
  }

  [[nodiscard]] const std::map<double, Vec>& values() const { return values_; }
  [[nodiscard]] double bound() const { return bound_; }

 private:
  using Place = std::map<double, Vec>::iterator;

  Place add(double t) {
    const auto [value, bounds] = reference_.at(t);
    if (!value.allFinite()) throw std::runtime_error("no value");
    if (bounds.size() > 0) bound_ = std::max(bound_, bounds.maxCoeff());
    return values_.insert_or_assign(t, value.head(columns_)).first;
  }

  // The place to go on from: the same, where a time was put behind it, or the next.
  Place refined(Place left) {
    const auto right = std::next(left);
    const double width = right->first - left->first;
    if (std::ssize(values_) >= most_times || width < 1e-5 * end_) return right;
    const Vec between = 0.5 * (left->second + right->second);
    const auto middle = add(left->first + 0.5 * width);
    const Vec away = (middle->second - between).cwiseAbs() - allowed * range_;
    return away.maxCoeff() > 0.0 ? left : right;
  }

  Reference reference_;
  Eigen::Index columns_;
  double end_, bound_ = 0.0;
  std::map<double, Vec> values_{};
  Vec range_{};
};

json solution(const Scene& scene) {
  const auto shown = std::min<Eigen::Index>(std::ssize(scene.outputs.names), most_columns);
  const Samples samples(scene, shown);
  json t = json::array();
  std::vector<json> values(static_cast<std::size_t>(shown), json::array());
  for (const auto& [time, value] : samples.values()) {
    t.push_back(in_chart(time));
    for (Eigen::Index c = 0; c < shown; ++c)
      values[static_cast<std::size_t>(c)].push_back(in_chart(value[c], digits));
  }
  const auto& names = scene.outputs.names;
  return {{"t", t},
          {"columns", std::vector<std::string>(names.begin(), names.begin() + shown)},
          {"values", values},
          {"bound", samples.bound()}};
}

}  // namespace

// Scenes of files are not at hand.
json solution_of(const SceneSettings& settings) {
  const SceneMaker* maker = settings.checksum.empty() ? find_scene(settings.id) : nullptr;
  if (maker == nullptr) return {};
  try {
    Scene scene = make_known_scene(*maker, settings.values);
    if (settings.until) scene.problem.end = *settings.until;
    return solution(scene);
  } catch (const std::exception&) {  // where there is no reference, a scene has no picture of it
    return {};
  }
}

}  // namespace fde
