// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <ostream>
#include <utility>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {
namespace {

// n numbers of an argument, or the initial value.
Vec state_of(const Given& given, std::string_view name, In at_start) {
  if (!given.has(name)) return at_start;
  const auto numbers = given.numbers(name);
  if (std::ssize(numbers) != at_start.size())
    given.refuse(name, fmt::format("{} numbers, one a coordinate", at_start.size()));
  return Eigen::Map<const Vec>(numbers.data(), std::ssize(numbers));
}

// Lines quantity,i,j,k,value. Indices are names of coordinates, of multipliers numbers. Collected first: what
// is not finite leaves nothing printed.
class NumberTable {
 public:
  explicit NumberTable(std::vector<std::string> names) : names_(std::move(names)) {}

  // indices: up to three.
  void add_line(std::string_view quantity, const std::vector<std::string>& indices, double value) {
    if (!std::isfinite(value)) throw NumericalFailure(fmt::format("the {} is not finite there", quantity));
    text_ += quantity;
    for (std::size_t place = 0; place < 3; ++place) {
      text_ += ',';
      if (place < indices.size()) text_ += indices[place];
    }
    text_ += fmt::format(",{:.17g}\n", value);
  }
  void add(std::string_view quantity, const std::vector<std::size_t>& indices, double value) {
    std::vector<std::string> names;
    for (const std::size_t index : indices) names.push_back(names_.at(index));
    add_line(quantity, names, value);
  }
  void add(std::string_view quantity, const Vec& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) add(quantity, {static_cast<std::size_t>(i)}, values[i]);
  }
  void add(std::string_view quantity, const Matrix& values) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(values.rows()); ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(values.cols()); ++j)
        add(quantity, {i, j}, values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::vector<std::string> names_;
  std::string text_ = "quantity,i,j,k,value\n";
};

std::string geometry_text(const std::vector<std::string>& names, const Geometry& geometry) {
  NumberTable table(names);
  table.add("metric", geometry.metric);
  for (std::size_t i = 0; i < geometry.christoffel.size(); ++i) {
    const Matrix& symbols = geometry.christoffel[i];
    for (std::size_t j = 0; j < names.size(); ++j) {
      for (std::size_t k = 0; k < names.size(); ++k) {
        const double symbol = symbols(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
        table.add("christoffel", {i, j, k}, symbol);
      }
    }
  }
  table.add("connection", geometry.connection);
  table.add("semispray", geometry.semispray);
  for (Eigen::Index i = 0; i < geometry.multipliers.size(); ++i)
    table.add_line("multiplier", {fmt::format("{}", i + 1)}, geometry.multipliers[i]);
  table.add("constrained_semispray", geometry.constrained_semispray);
  table.add("constrained_connection", geometry.constrained_connection);
  return table.text();
}

// The velocities of the argument, which have to keep the constraints at q to a millionth of themselves. Those
// at t = 0 are brought onto the constraints, which at another place may be others.
Vec velocity_at(In q, const StateGeometry& geometry, const Given& given) {
  constexpr double typed = 1e-6;
  Vec v = state_of(given, "--velocity", geometry.velocity);
  if (!geometry.allowed) return v;
  Vec allowed = geometry.allowed(q, v);
  if (given.has("--velocity") && (v - allowed).norm() > typed * allowed.norm()) {
    given.refuse("--velocity", fmt::format("velocities that keep the constraints at this place, as {:.17g}",
                                           fmt::join(allowed.begin(), allowed.end(), ",")));
  }
  return allowed;
}

void print_geometry(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto variant = read_variant(given, known);
  const Scene scene = make_scene_unchecked(variant);
  if (!scene.geometry)
    reject_text("scene", variant.factory->id, "one of mechanics with a metric and constraints");
  const Vec q = state_of(given, "--place", scene.geometry.position),
            v = velocity_at(q, scene.geometry, given);
  streams.out << geometry_text(scene.geometry.coordinates, scene.geometry.at(q, v));
}

}  // namespace

Command geometry_command() {
  return {{"geometry",
           "Look up",
           "Print metric, Christoffel symbols, connection and semispray of a scene; CSV",
           {scene_argument("id of a scene of mechanics"),
            set_argument(),
            {"[--place Q1,Q2,...]", "coordinates", any_number, "those at t = 0"},
            {"[--velocity V1,V2,...]", "velocities that keep the constraints", any_number, "those at t = 0"}},
           {{"fdebench geometry loxodrome --place 0.7,0", "prints the Christoffel symbols at theta = 0.7."},
            {"fdebench geometry knife_edge", "prints the geometry at the start of the motion."}},
           {"scenes", "solve"}},
          print_geometry};
}

}  // namespace fde::bench
