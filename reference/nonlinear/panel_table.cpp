// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/panel_table.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "fdebench/reference/nonlinear/collocation/panels.hpp"

namespace fde::reference {

namespace {

class TableReference {
 public:
  TableReference(PanelTable table, Vec initial_bound)
      : table_(std::move(table)),
        bound_of_start_(std::move(initial_bound)),
        basis_(static_cast<int>(table_.panels.front().values.rows()) - 2, PanelPoints::legendre) {}

  [[nodiscard]] ReferenceValue at(double t) const {
    const auto& panels = table_.panels;
    const double end = panels.back().to;
    if (!(t >= 0.0 && t <= end)) {
      throw std::invalid_argument("reference solution: t = " + std::to_string(t) + " is outside [0, " +
                                  std::to_string(end) + "]");
    }
    const auto panel = std::ranges::lower_bound(panels, t, {}, &ReferencePanel::to);
    return {basis_.interpolate(panel->values, (t - panel->from) / (panel->to - panel->from)),
            t > 0.0 ? panel->bound : bound_of_start_};
  }

 private:
  PanelTable table_;
  Vec bound_of_start_;
  PanelBasis basis_;
};

}  // namespace

Reference reference_from_panels(PanelTable table, Vec initial_bound) {
  const auto reference = std::make_shared<const TableReference>(std::move(table), std::move(initial_bound));
  return {.at = [reference](double t) { return reference->at(t); }};
}

}  // namespace fde::reference
