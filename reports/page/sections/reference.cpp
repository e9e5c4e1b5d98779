#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "analysis/text.hpp"
#include "page/page_data.hpp"

namespace fde {
namespace {

constexpr double largest_share = 0.1;
constexpr auto errors_at_end = "error at the end", errors_over_all = "largest error over all times";

// The smallest error of a scene in one norm beside the reference's own: three cells, empty ones where no run
// has both.
std::vector<Cell> reference_cells(const PageInput& page, RunSpan scene, std::string_view error_id,
                                  std::string_view bound_id) {
  const MeasuredRun* best = nullptr;
  for (const MeasuredRun& run : scene) {
    if (run[error_id] && run[bound_id] && (best == nullptr || *run[error_id] < *(*best)[error_id]))
      best = &run;
  }
  if (best == nullptr) return std::vector<Cell>(3);
  const double error = *(*best)[error_id], bound = *(*best)[bound_id];
  Cell share{.text = error > 0.0 ? error_text(bound / error) : "the error is 0"};
  if (bound > largest_share * error) {
    share.marked = true;
    share.detail = "not resolved by the reference";
  }
  const std::string label = page.label(best->key);
  return {{.text = error_text(bound)},
          {.text = error_text(error),
           .detail = fmt::format("{}, N = {}", label, count_text(best->steps)),
           .line = label},
          share};
}

// Empty: nothing is known of this scene.
std::vector<Cell> reference_row(const PageInput& page, RunSpan scene) {
  const auto& of = scene.front().key.scene;
  std::vector<Cell> row{{.text = name_of_scene(of).title, .detail = label_of(of)}};
  std::ranges::copy(reference_cells(page, scene, "error_end", "reference_bound"), std::back_inserter(row));
  std::ranges::copy(reference_cells(page, scene, "error_maximum", "reference_bound_maximum"),
                    std::back_inserter(row));
  const bool known =
      std::any_of(row.begin() + 1, row.end(), [](const Cell& cell) { return !cell.text.empty(); });
  return known ? row : std::vector<Cell>();
}

}  // namespace

Section reference_section(const PageInput& page) {
  Section section{
      .id = "reference",
      .title = "How far the reference is known",
      .paragraphs = {"An error means something only as far as it is above the error of the reference itself: "
                     "a bound where the solution is known in closed form, an estimate elsewhere. It is set "
                     "against the smallest error measured on the scene."},
      .table = {.caption = "The reference's own error against the smallest error measured",
                .columns = {{"scene"},
                            {"reference", errors_at_end},
                            {"smallest measured", errors_at_end},
                            {"ratio", errors_at_end},
                            {"reference", errors_over_all},
                            {"smallest measured", errors_over_all},
                            {"ratio", errors_over_all}}}};
  RowGroup rows;
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    if (auto cells = reference_row(page, scene); !cells.empty()) rows.rows.push_back(std::move(cells));
  }
  if (!rows.rows.empty()) section.table.groups.push_back(std::move(rows));
  return section;
}

}  // namespace fde
