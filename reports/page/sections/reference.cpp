#include <fmt/format.h>

#include "analysis/text.hpp"
#include "page/page_data.hpp"

namespace fde {
namespace {

constexpr double largest_share = 0.1;

// The smallest error of a scene beside the reference's own; empty: no run has both.
std::vector<Cell> reference_row(const PageInput& page, RunSpan scene) {
  const MeasuredRun* best = nullptr;
  for (const MeasuredRun& run : scene) {
    if (run["error_end"] && run["reference_bound"] &&
        (best == nullptr || *run["error_end"] < *(*best)["error_end"])) {
      best = &run;
    }
  }
  if (best == nullptr) return {};
  const double error = *(*best)["error_end"], bound = *(*best)["reference_bound"];
  Cell share{.text = error > 0.0 ? error_text(bound / error) : "the error is 0"};
  if (bound > largest_share * error) {
    share.marked = true;
    share.detail = "the reference does not resolve this error";
  }
  const std::string label = page.label(best->key);
  return {{.text = name_of_scene(best->key.scene).title, .detail = label_of(best->key.scene)},
          {.text = error_text(bound)},
          {.text = error_text(error),
           .detail = fmt::format("{}, N = {}", label, count_text(best->steps)),
           .line = label},
          share};
}

}  // namespace

Section reference_section(const PageInput& page) {
  Section section{
      .id = "reference",
      .title = "How far the reference is known",
      .paragraphs = {"An error means something only as far as it is above the error of the reference itself: "
                     "a bound where the solution is known in closed form, an estimate elsewhere. It is set "
                     "against the smallest error measured on the scene."},
      .table = {
          .caption = "The reference's own error against the smallest error measured",
          .columns = {{"scene"}, {"error of the reference"}, {"smallest error at the end"}, {"ratio"}}}};
  RowGroup rows;
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    if (auto cells = reference_row(page, scene); !cells.empty()) rows.rows.push_back(std::move(cells));
  }
  if (!rows.rows.empty()) section.table.groups.push_back(std::move(rows));
  return section;
}

}  // namespace fde
