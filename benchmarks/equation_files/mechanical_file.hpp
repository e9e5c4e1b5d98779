// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/mechanics/extremum_scene.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"
#include "fdebench/benchmarks/mechanics/motion_start.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// The mechanical system of a file with [mechanics]. Throws std::invalid_argument naming file, line and
// column, the text there and what is allowed.
struct MechanicalFile {
  mechanics::MechanicalSystem system{};
  bool is_extremum = false;  // principle = "vakonomic", D(x, a) in the Lagrangian, or values at the end
  bool starts_with_velocities = true;
  bool has_positions_only = false;  // a Lagrangian without velocities, whose D(x, a) are infinite at the end
  mechanics::ExtremumEnds ends{};
  std::map<int, std::string> names{};  // of [columns], by variable
};
MechanicalFile read_mechanical_file(FileFormulas& formulas);

// Its columns: the coordinates, the velocities as D(x,1), and the memory terms as D(x,0.5), with the names of
// [columns]. Memory terms of order 1 are columns if they are named there.
std::vector<SystemColumn> columns_of(const MechanicalFile& file);

// Its scene, with a reference if it is linear. Throws in the same way if the motion does not start regularly.
// `on_note` gets a line about initial velocities that were projected onto the constraints.
Scene mechanical_file_scene(MechanicalFile file, FileFormulas& formulas, const Parameters& parameters,
                            const std::function<void(const std::string& note)>& on_note);

// Runs a function whose errors are those of the Lagrangian or of a constraint.
template <class Function>
auto with_positions(const FileFormulas& formulas, const Function& function) {
  const auto& mechanics = *formulas.text().mechanics;
  try {
    return function();
  } catch (const mechanics::ConstraintError& fault) {
    formulas.reject(mechanics.constraints[fault.constraint], fault.what());
  } catch (const std::invalid_argument& fault) {
    formulas.reject(mechanics.lagrangian, fault.what());
  }
}

// The parameters of a file with [mechanics] besides its own: `formulation` and `kappa` if there are
// constraints, and with initial velocities, unless the scene is built in, `initial_velocity`.
std::vector<Parameter> formulation_parameters(const EquationText& text);

// The parameters of a file with their default values.
Parameters default_parameters(const EquationText& text);

}  // namespace fde::bench
