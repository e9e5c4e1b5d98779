// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/piecewise_constant_multipliers.hpp"
#include "fdebench/schemes/rules/spectral/panel_collocation.hpp"
#include "fdebench/schemes/rules/two_sided/two_sided_collocation.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

Scheme spectral_collocation() {
  return {
      .id = "spectral_collocation",
      .title = "Spectral collocation on panels",
      .source =
          "Brunner, Collocation Methods for Volterra Integral Equations (2004), chapter 6; the memory term "
          "as Greengard & Rokhlin, J. Comput. Phys. 73 (1987)",
      .capabilities = {.resolution = ResolutionKind::tolerance,
                       .implicit = true,
                       .algebraic_rows = true,
                       .is_two_sided = true},
      .solve =
          [](const Problem& problem, const Resolution& resolution, const Options& options) {
            const auto& accuracy = std::get<Tolerance>(resolution);
            if (has_right_rows(problem)) return solve_on_panels(problem, accuracy, options);
            return integrate(PanelCollocation(problem, accuracy, options));
          },
      .unsupported_problem_reason = [](const Problem& problem) -> std::optional<std::string> {
        if (has_sparse_jacobian(problem) && !IntegratedRows(problem).have_one_order())
          return "takes sparse Jacobians only where all rows have one order";
        if (!has_right_rows(problem)) return std::nullopt;
        if (!problem.switching_functions.empty()) return "locates switches in steps from the left only";
        return unsupported_multipliers_reason(problem);
      }};
}

}  // namespace fde
