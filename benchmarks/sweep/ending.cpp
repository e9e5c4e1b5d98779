#include "sweep/ending.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace fde {
namespace {

struct Words {
  Ending ending;
  std::string_view words;
};
constexpr std::array all_words{Words{Ending::finished, "finished"},
                               Words{Ending::accuracy_lost, "accuracy lost"},
                               Words{Ending::overflow, "the solution is beyond double"},
                               Words{Ending::no_reference, "no reference: "},
                               Words{Ending::singular, "ran into the singularity"},
                               Words{Ending::refused, "refused: "}};

std::string reason(const Problem& problem, Ending outcome) {
  switch (outcome) {
    case Ending::finished:
      return std::string(words(Ending::finished));
    case Ending::not_finite:
      return "not finite";
    case Ending::not_converged:
      return "Newton's method did not converge";
    case Ending::singular:
      return fmt::format("{} {}", words(Ending::singular), problem.domain.edge);
    case Ending::out_of_budget:
      return "out of its budget of time";
    default:
      throw std::logic_error("an ending that is no scheme's");
  }
}

}  // namespace

std::string_view words(Ending ending) {
  for (const auto& entry : all_words) {
    if (entry.ending == ending) return entry.words;
  }
  return {};
}

Ending ending_of(std::string_view status) {
  for (const auto& entry : all_words) {
    if (status.starts_with(entry.words)) return entry.ending;
  }
  return Ending::failed;
}

bool is_compared(Ending ending) { return ending == Ending::finished || ending == Ending::accuracy_lost; }

std::string describe(const Problem& problem, const Trajectory& path) {
  const auto why = reason(problem, path.ending);
  return path.failed_at ? at_step(why, path.steps + 1, *path.failed_at) : why;
}

std::string at_step(std::string_view what, std::int64_t step, double t) {
  return fmt::format("{} at step {}, t = {:.6g}", what, step, t);
}

std::string at_time(std::string_view what, const Resolution& resolution, double t) {
  if (const auto* grid = std::get_if<Grid>(&resolution)) return at_step(what, grid->number(t), t);
  return fmt::format("{} at t = {:.6g}", what, t);
}

}  // namespace fde
