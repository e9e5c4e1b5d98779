#include <fmt/format.h>

#include "analysis/answer.hpp"
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

std::string advice(const Results& results, std::string_view scene, double error) {
  const Runs runs = runs_of(results);
  const auto ranked = cheapest(runs, scene, error);
  std::string text;
  for (const Choice& choice : ranked)
    text += fmt::format("{} ({}): {}\n", choice.scheme, choice.history, describe(choice));
  if (!ranked.empty()) return text;
  const auto missed = shortfall(runs, scene, error);
  if (!missed) return fmt::format("no run of {} finished\n", scene);
  text = fmt::format("no run of {} reaches {}; best: {} ({}): {}\n", scene, error_text(error),
                     missed->best.scheme, missed->best.history, describe(missed->best));
  if (missed->needed) text += describe(*missed->needed) + "\n";
  return text;
}

}  // namespace fde
