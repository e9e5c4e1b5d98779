// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

inline SceneFactory maker_of(std::string_view text) {
  return equation_scene(parse_equation_text("test.toml", text));
}

inline Scene scene_of_text(std::string_view text, const ParameterValues& values = {}) {
  return make_scene(maker_of(text), values);
}

// One unknown x of this order with this right-hand side, x(0) = 1.
inline std::string relaxation_file(const std::string& rhs, const std::string& order = "0.5") {
  return "end = 1\n[unknown.x]\norder = " + order + "\nrhs = \"" + rhs + "\"\ninitial = [1]\n";
}

// The names of formulas in the time and two unknowns.
inline FormulaNames names_of_t_x_y(ExpressionPool& pool) {
  return {.resolve = [&pool](std::string_view name) -> std::optional<Expression> {
            if (name == "t") return pool.variable(0);
            if (name == "x") return pool.variable(1);
            if (name == "y") return pool.variable(2);
            return std::nullopt;
          },
          .accepted_names = {"t", "x", "y"}};
}

// A file of docs/examples.
inline std::string example(const std::string& name) { return FDE_SOURCE_DIR "/docs/examples/" + name; }

inline Scene scene_of_example(const std::string& name, const ParameterValues& values = {}) {
  return make_scene(equation_scene(read_equation_text(example(name))), values);
}

}  // namespace fde::bench
