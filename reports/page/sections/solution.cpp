#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
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

constexpr int times = 240;
constexpr Eigen::Index most_columns = 6;  // of hundreds of a diffusion
constexpr int digits = 4;

// Closer at the start, where solutions rise like a power below 1.
double time(double end, int i) { return end * std::pow(static_cast<double>(i) / times, 1.5); }

json solution(const Scene& scene) {
  const Reference reference = reference_of(scene);
  const auto shown = std::min<Eigen::Index>(std::ssize(scene.outputs.names), most_columns);
  json found{{"t", json::array()},
             {"columns",
              std::vector<std::string>(scene.outputs.names.begin(), scene.outputs.names.begin() + shown)}};
  std::vector<json> values(static_cast<std::size_t>(shown), json::array());
  double bound = 0.0;
  for (int i = 0; i <= times; ++i) {
    const double t = time(scene.problem.end, i);
    const auto [value, bounds] = reference.at(t);
    if (!value.allFinite()) continue;
    found["t"].push_back(in_chart(t, digits));
    for (Eigen::Index c = 0; c < shown; ++c)
      values[static_cast<std::size_t>(c)].push_back(in_chart(value[c], digits));
    if (bounds.size() > 0) bound = std::max(bound, bounds.maxCoeff());
  }
  found["values"] = values;
  found["bound"] = bound;
  return found;
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
