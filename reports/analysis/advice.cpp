#include <fmt/format.h>

#include "analysis/answer.hpp"
#include "analysis/line_names.hpp"
#include "analysis/text.hpp"

namespace fde {

std::string describe(const Choice& choice) {
  return fmt::format("N = {}, {}, error {}", count_text(choice.steps), time_text(choice.seconds),
                     error_text(choice.error));
}

std::string describe(const Extrapolation& needed) {
  return fmt::format("{} would need about {} steps: extrapolated at rate {:.2f}, not measured", needed.scheme,
                     rough_count_text(needed.steps), needed.rate);
}

std::string advice(const Results& results, const SceneSettings& scene, double error) {
  const Runs runs = runs_of(results);
  const LineNames names(runs);
  const auto line = [&](const Choice& choice) {
    return fmt::format("{}: {}\n", names.name_with_history(choice.scheme, choice.setup), describe(choice));
  };
  std::string text;
  for (const Choice& choice : cheapest(runs, scene, error)) text += line(choice);
  if (!text.empty()) return text;
  const auto missed = shortfall(runs, scene, error);
  if (!missed) return fmt::format("no run of {} finished\n", label_of(scene));
  text = fmt::format("no run of {} reaches {}; best: {}", label_of(scene), error_text(error),
                     line(missed->best));
  if (missed->needed) text += describe(*missed->needed) + "\n";
  return text;
}

}  // namespace fde
