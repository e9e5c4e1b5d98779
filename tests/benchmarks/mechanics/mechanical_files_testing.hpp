// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/equation_files/mechanical_file.hpp"
#include "fdebench/benchmarks/mechanics/dynamics.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// A mechanical system as it is written in a file.
struct WrittenSystem {
  std::vector<std::string> coordinates{};
  std::vector<double> position{}, velocity{};  // at t = 0
  std::string lagrangian{};
  std::vector<std::string> constraints{};
  std::vector<std::string> forces{};  // of each coordinate, or empty
};

// Its file, with further lines of [mechanics].
inline std::string mechanical_file_of(const WrittenSystem& system, const std::string& lines = {}) {
  std::string text = "end = 1\n";
  for (std::size_t i = 0; i < system.coordinates.size(); ++i) {
    text += fmt::format("[coordinate.{}]\ninitial = [{}, {}]\n", system.coordinates[i], system.position[i],
                        system.velocity[i]);
  }
  text += fmt::format("[mechanics]\nlagrangian = \"{}\"\n", system.lagrangian);
  for (std::size_t i = 0; i < system.forces.size(); ++i)
    text += fmt::format("forces.{} = \"{}\"\n", system.coordinates[i], system.forces[i]);
  if (!system.constraints.empty())
    text += fmt::format("constraints = [\"{}\"]\n", fmt::join(system.constraints, "\", \""));
  return text + lines;
}

inline Scene scene_of_mechanical_file(std::string_view text, const ParameterValues& values = {}) {
  return make_scene(equation_scene(parse_equation_text("test.toml", text)), values);
}

// The equations of motion of a file, as expressions.
class DynamicsOfFile {
 public:
  explicit DynamicsOfFile(std::string_view toml)
      : text_(parse_equation_text("test.toml", toml)),
        parameters_(text_.file, declared(text_), {}),
        formulas_(text_, parameters_, NumberStorage::values),
        system(read_mechanical_file(formulas_).system),
        algebra(formulas_.pool()),
        dynamics(system, algebra) {}
  DynamicsOfFile(const DynamicsOfFile&) = delete;
  DynamicsOfFile& operator=(const DynamicsOfFile&) = delete;

  // The values of expressions of t and of these variables in order, the columns first.
  [[nodiscard]] Vec values(const mechanics::Expressions& of, double t, const std::vector<Vec>& parts) const {
    Eigen::Index size = 0;
    for (const auto& part : parts) size += part.size();
    Vec variables(size);
    size = 0;
    for (const auto& part : parts) {
      variables.segment(size, part.size()) = part;
      size += part.size();
    }
    return mechanics::values_at(algebra.pool(), of, t, variables);
  }
  [[nodiscard]] Matrix values(const mechanics::ExpressionMatrix& of, double t,
                              const std::vector<Vec>& parts) const {
    const auto rows = static_cast<Eigen::Index>(of.rows), columns = static_cast<Eigen::Index>(of.columns);
    return values(of.entries, t, parts).reshaped<Eigen::RowMajor>(rows, columns);
  }

 private:
  static std::vector<Parameter> declared(const EquationText& text) {
    std::vector<Parameter> all;
    for (const auto& parameter : text.parameters) all.push_back(parameter.declared);
    return all;
  }

  EquationText text_;
  Parameters parameters_;
  FileFormulas formulas_;

 public:
  const mechanics::MechanicalSystem system;
  const mechanics::Algebra algebra;
  const mechanics::Dynamics dynamics;
};

}  // namespace fde::bench
