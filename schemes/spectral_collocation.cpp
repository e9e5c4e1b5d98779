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
      .needs = {.solves_on_grid = false, .takes_accuracy = true, .implicit = true, .algebraic_rows = true},
      .solve =
          [](const Problem& problem, const Resolution& resolution, const Options& options) {
            return PanelCollocation(problem, std::get<Tolerance>(resolution), options).solve();
          },
      .refuses = [](const Problem& problem) -> std::optional<std::string> {
        if (sparse(problem)) return "takes dense Jacobians only";
        return std::nullopt;
      }};
}

}  // namespace fde
