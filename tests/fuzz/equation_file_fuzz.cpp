// SPDX-License-Identifier: MIT
// Arbitrary text as an equation file: either a scene with its problem, a few steps and its exact reference,
// or a one-line error.

#include <iterator>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"
#include "fuzz/fuzzing.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

void require_shapes(const Scene& scene) {
  const auto size = scene.problem.size();
  fuzz::require(scene.outputs.evaluate || std::ssize(scene.outputs.names) == size,
                "a column for each component");
  fuzz::require(scene.smoothness.powers.empty() || std::ssize(scene.smoothness.powers) == size,
                "start powers of all rows, or of none");
}

void evaluate(const Scene& scene) {
  const Problem& problem = scene.problem;
  Vec y(problem.size()), f(problem.size());
  for (Eigen::Index i = 0; i < y.size(); ++i)
    y[i] = problem.components[static_cast<std::size_t>(i)].initial[0];
  problem.rhs(0.5 * problem.end, y, f);
  const Matrix jacobian = jacobian_at(problem, 0.5 * problem.end, y);
  fuzz::require(jacobian.rows() == y.size(), "a row of derivatives for each component");
  const Vec columns = columns_at(scene.outputs, 0.0, y);
  [[maybe_unused]] const Vec values = printed_values(scene, 0.0, columns);
}

void solve(const Scene& scene, std::string_view scheme) {
  constexpr int steps = 5;
  const Grid grid{scene.problem.end, steps};
  const auto* found = find_scheme(scheme);
  if (unsupported_reason(*found, scene.problem, grid)) return;
  const auto path = found->solve(scene.problem, grid, {.budget = 0.5});
  fuzz::require(path.status != SolveStatus::finished || path.y.allFinite(), "what finished is finite",
                scene.name);
}

}  // namespace

FDE_FUZZ_TARGET(equation_file) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  fuzz::require_one_line_errors([&] {
    const Scene scene = make_scene(equation_scene(parse_equation_text("fuzz.toml", text)));
    require_shapes(scene);
    evaluate(scene);
    solve(scene, "adams_pc");
    solve(scene, "product_trapezoidal");
    if (scene.reference.at && size % 4 == 0) [[maybe_unused]]
      const auto known = scene.reference.at(0.5 * scene.problem.end);
  });
  return 0;
}
