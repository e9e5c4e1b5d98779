// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_collocation.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

Scheme spectral_collocation() {
  return {
      .id = "spectral_collocation",
      .title = "Spectral collocation on panels",
      .source =
          "Brunner, Collocation Methods for Volterra Integral Equations (2004), chapter 6; the memory term "
          "as Greengard & Rokhlin, J. Comput. Phys. 73 (1987)",
      .capabilities = {.resolution = ResolutionKind::tolerance, .implicit = true, .algebraic_rows = true},
      .solve =
          [](const Problem& problem, const Resolution& resolution, const Options& options) {
            return integrate(PanelCollocation(problem, std::get<Tolerance>(resolution), options));
          },
      .unsupported_problem_reason = [](const Problem& problem) -> std::optional<std::string> {
        if (has_sparse_jacobian(problem)) return "takes dense Jacobians only";
        return std::nullopt;
      }};
}

}  // namespace fde
